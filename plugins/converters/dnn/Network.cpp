// SPDX-License-Identifier: BSD-3-Clause
#include "Network.h"

#include "OnnxFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"

#include <opencv2/core/utils/logger.hpp>

#include <algorithm>
#include <filesystem>

namespace voxeland
{
namespace
{
namespace logging = cv::utils::logging;

/** Keeps OpenCV from printing while it lives: what goes wrong is said in an exception. */
class SilentOpenCV
{
 public:
    SilentOpenCV() : m_before(logging::setLogLevel(logging::LOG_LEVEL_SILENT)) {}
    ~SilentOpenCV() { logging::setLogLevel(m_before); }
    SilentOpenCV(const SilentOpenCV&) = delete;
    SilentOpenCV& operator=(const SilentOpenCV&) = delete;

 private:
    logging::LogLevel m_before;
};

/** What to do about a model that OpenCV cannot use.
 *  \param options those of Ultralytics' export that may help */
std::string remedy(std::vector<std::string> options)
{
    options.insert(options.end(), {"opset=12", "simplify=True"});
    return ": export it anew with " + joined(options, " ") + ", or use a newer OpenCV";
}

/** Weights as they were trained are no network that OpenCV reads. */
void checkExported(const std::string& model)
{
    const std::string extension = std::filesystem::path(model).extension().string();
    for (const char* trained : {".pt", ".pth", ".safetensors", ".torchscript"})
        if (extension == trained)
            throw InputError("the model '" + model + "' is not exported: yolo export model=" +
                             std::filesystem::path(model).filename().string() +
                             " format=onnx opset=12 simplify=True makes an .onnx of it");
}

/** Why a model cannot be loaded: OpenCV reports over several lines, this is one sentence. */
InputError loadFailure(const std::string& model, const cv::Exception& e, const std::string& remedy)
{
    const std::string opencv = "OpenCV " + cv::getVersionString();
    static const std::string NODE = "Node [";
    if (const size_t found = e.err.find(NODE); found != std::string::npos) {
        const size_t begin = found + NODE.size();
        const std::string operation = e.err.substr(begin, e.err.find_first_of("]@", begin) - begin);
        return InputError("the model '" + model + "' has an operation '" + operation + "' that " +
                          opencv + " lacks or cannot do this way" + remedy);
    }
    return InputError(opencv + " cannot use the model '" + model +
                      "': " + e.err.substr(0, e.err.find('\n')) + remedy);
}

/** Name and type of the first layer that fails on the input that was set; empty if none does. */
std::string firstFailingLayer(cv::dnn::Net& net)
{
    const std::vector<std::string> names = net.getLayerNames();
    const auto works = [&net](const std::string& name) {
        try {
            net.forward(name);
            return true;
        } catch (const cv::Exception&) {
            return false;
        }
    };
    const auto first = std::partition_point(names.begin(), names.end(), works);
    if (first == names.end()) return {};
    const std::string name = first->substr(first->find('!') + 1);  // OpenCV adds "onnx_node!"
    return "'" + name + "' (" + net.getLayer(net.getLayerId(*first))->type + ")";
}

/** Why a model cannot be run on the input that was set, in one sentence. */
InputError runFailure(const std::string& model, cv::dnn::Net& net, const cv::Exception& e,
                      const std::string& remedy)
{
    const std::string opencv = "OpenCV " + cv::getVersionString();
    const std::string layer = firstFailingLayer(net);
    if (!layer.empty())
        return InputError(opencv + " cannot do the operation " + layer + " of the model '" + model +
                          "'" + remedy);
    return InputError(opencv + " cannot run the model '" + model +
                      "': " + e.err.substr(0, e.err.find('\n')) + remedy);
}
}  // namespace

const Words<cv::dnn::Backend>& backendWords()
{
    static const Words<cv::dnn::Backend> WORDS = {
        {"opencv", cv::dnn::DNN_BACKEND_OPENCV},
        {"openvino", cv::dnn::DNN_BACKEND_INFERENCE_ENGINE},
        {"cuda", cv::dnn::DNN_BACKEND_CUDA},
        {"vulkan", cv::dnn::DNN_BACKEND_VKCOM}};
    return WORDS;
}

const Words<cv::dnn::Target>& targetWords()
{
    static const Words<cv::dnn::Target> WORDS = {{"cpu", cv::dnn::DNN_TARGET_CPU},
                                                 {"opencl", cv::dnn::DNN_TARGET_OPENCL},
                                                 {"opencl_fp16", cv::dnn::DNN_TARGET_OPENCL_FP16},
                                                 {"cuda", cv::dnn::DNN_TARGET_CUDA},
                                                 {"cuda_fp16", cv::dnn::DNN_TARGET_CUDA_FP16},
                                                 {"vulkan", cv::dnn::DNN_TARGET_VULKAN}};
    return WORDS;
}

std::string shapesText(const std::vector<NetworkOutput>& outputs)
{
    std::string text;
    for (const auto& [name, tensor] : outputs) {
        text += (text.empty() ? "" : ", ") + name + " ";
        for (int d = 0; d < tensor.dims; ++d)
            text += (d == 0 ? "" : "x") + std::to_string(tensor.size[d]);
    }
    return text;
}

Network::Network(const NetworkFiles& files, const NetworkDevice& device) : m_model(files.model)
{
    if (!std::filesystem::is_regular_file(m_model))
        throw InputError("there is no model '" + m_model + "'");
    checkExported(m_model);
    const SilentOpenCV silent;
    try {
        if (std::filesystem::path(m_model).extension() == ".onnx") {
            OnnxFile onnx(m_model);
            m_inputSize = onnx.input;
            m_classNames = std::move(onnx.classNames);
            m_remedy = remedy(std::move(onnx.exportOptions));
            m_net = cv::dnn::readNetFromONNX(onnx.bytes);
        } else {
            m_net = cv::dnn::readNet(m_model, files.config);
        }
    } catch (const cv::Exception& e) {
        throw loadFailure(m_model, e, m_remedy);
    }
    choose(device);
}

void Network::choose(const NetworkDevice& device)
{
    std::string wanted, available;
    bool isThere = false;
    for (const auto& [backendWord, backend] : backendWords()) {
        const auto targets = cv::dnn::getAvailableTargets(backend);
        for (const auto& [targetWord, target] : targetWords()) {
            const std::string text = "backend = " + backendWord + " with target = " + targetWord;
            const bool isWanted = backend == device.backend && target == device.target;
            if (isWanted) wanted = text;
            if (std::find(targets.begin(), targets.end(), target) == targets.end()) continue;
            isThere = isThere || isWanted;
            available += (available.empty() ? "" : ", ") + text;
        }
    }
    if (!isThere)
        throw ConfigurationError("[converter] " + wanted + ": OpenCV " + cv::getVersionString() +
                                 " on this machine cannot run networks so; it can with " +
                                 available);
    m_net.setPreferableBackend(device.backend);
    m_net.setPreferableTarget(device.target);
}

bool Network::hasLayer(const std::string& name) const
{
    const auto names = m_net.getLayerNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<NetworkOutput> Network::run(const cv::Mat& images, std::vector<std::string> names) const
{
    const SilentOpenCV silent;
    const std::lock_guard<std::mutex> lock(m_mutex);
    std::vector<NetworkOutput> outputs;
    try {
        if (names.empty()) names = m_net.getUnconnectedOutLayersNames();
        std::vector<cv::Mat> tensors;
        m_net.setInput(images);
        m_net.forward(tensors, names);
        for (size_t i = 0; i < names.size(); ++i) {
            tensors[i].convertTo(tensors[i], CV_32F);
            outputs.push_back({names[i], tensors[i].clone()});  // the next run writes to the same
        }
    } catch (const cv::Exception& e) {
        throw runFailure(m_model, m_net, e, m_remedy);
    }
    return outputs;
}
}  // namespace voxeland
