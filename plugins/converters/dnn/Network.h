// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <opencv2/dnn.hpp>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace voxeland
{
/** One of a network's results. */
struct NetworkOutput
{
    std::string name;
    cv::Mat tensor;  //!< of float
};

/** Shapes of outputs, for messages: "output0 1x116x8400, output1 1x32x160x160". */
std::string shapesText(const std::vector<NetworkOutput>& outputs);

/** Values with the words that stand for them in an INI. */
template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

/** What may run networks, whether this OpenCV has it or not. */
const Words<cv::dnn::Backend>& backendWords();
/** Where they may run. */
const Words<cv::dnn::Target>& targetWords();

/** Where a network comes from. */
struct NetworkFiles
{
    std::string model;   //!< ONNX if the name ends so, otherwise whatever OpenCV knows
    std::string config;  //!< description of the graph, for frozen TensorFlow graphs; may be empty
};

/** Where a network runs. */
struct NetworkDevice
{
    cv::dnn::Backend backend = cv::dnn::DNN_BACKEND_OPENCV;
    cv::dnn::Target target = cv::dnn::DNN_TARGET_CPU;
};

/** A network that OpenCV runs. */
class Network
{
 public:
    /** \throws InputError if the model cannot be used, ConfigurationError if this OpenCV lacks the
     *  device */
    Network(const NetworkFiles& files, const NetworkDevice& device);

    /** Size of the input [pixels]; 0x0 if the model does not say. */
    [[nodiscard]] const cv::Size& inputSize() const { return m_inputSize; }
    /** Names of the classes that the model holds; may be empty. */
    [[nodiscard]] const std::vector<std::string>& classNames() const { return m_classNames; }
    /** Whether there is a layer of that name. */
    [[nodiscard]] bool hasLayer(const std::string& name) const;

    /** Runs the network; thread safe, one run after another.
     *  \param images batch x channels x height x width
     *  \param outputs names of the layers whose results are wanted; empty: the last ones
     *  \throws InputError if it cannot be run on this */
    [[nodiscard]] std::vector<NetworkOutput> run(const cv::Mat& images,
                                                 std::vector<std::string> outputs = {}) const;

 private:
    void choose(const NetworkDevice& device);

    std::string m_model;
    std::string m_remedy;  //!< what to do if OpenCV cannot use it
    mutable std::mutex m_mutex;
    mutable cv::dnn::Net m_net;  //!< running it changes it
    cv::Size m_inputSize;
    std::vector<std::string> m_classNames;
};
}  // namespace voxeland
