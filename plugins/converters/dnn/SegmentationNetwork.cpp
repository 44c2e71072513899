// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationNetwork.h"

#include "voxeland/base/errors.h"

#include <limits>

namespace voxeland
{
namespace
{
constexpr auto BOXES = "detection_out_final", MASKS = "detection_masks";  // of Mask R-CNN
constexpr bool RED_FIRST = true;

void checkInputSize(const std::string& model, const cv::Size& own, const cv::Size& asked)
{
    const auto agree = [](int a, int b) { return a == 0 || b == 0 || a == b; };
    if (!agree(own.width, asked.width) || !agree(own.height, asked.height))
        throw ConfigurationError("[converter] input_width and input_height: the model '" + model +
                                 "' takes images of " + std::to_string(own.width) + "x" +
                                 std::to_string(own.height) + " only, leave them 0");
}
}  // namespace

SegmentationNetwork::SegmentationNetwork(const NetworkFiles& files, const NetworkDevice& device,
                                         OutputLayout layout, const cv::Size& input)
    : m_model(files.model), m_network(files, device), m_layout(layout), m_input(input)
{
    checkInputSize(m_model, m_network.inputSize(), m_input);
    const bool isMaskRcnn = m_network.hasLayer(BOXES) && m_network.hasLayer(MASKS);
    if (m_layout == OutputLayout::maskRcnn && !isMaskRcnn)
        throw InputError("the model '" + m_model + "' has no outputs " + BOXES + " and " + MASKS +
                         ": leave the layout to be recognized");
    if (isMaskRcnn && m_layout == OutputLayout::automatic) m_layout = OutputLayout::maskRcnn;
    if (m_layout == OutputLayout::maskRcnn) return;
    const cv::Mat black(64, 64, CV_8UC3, cv::Scalar::all(0));
    const auto outputs = run(black, Letterbox(black.size(), inputSizeFor(black.size())));
    m_layout = layoutOf(outputs);
    m_classes = numberOfClasses(m_layout, outputs);
}

cv::Size SegmentationNetwork::inputSizeFor(const cv::Size& image) const
{
    constexpr int USUAL = 640;
    cv::Size size = m_network.inputSize();
    if (size.empty()) size = m_layout == OutputLayout::maskRcnn ? image : cv::Size(USUAL, USUAL);
    if (m_input.width > 0) size.width = m_input.width;
    if (m_input.height > 0) size.height = m_input.height;
    return size;
}

std::vector<NetworkOutput> SegmentationNetwork::run(const cv::Mat& image,
                                                    const Letterbox& letterbox) const
{
    if (m_layout == OutputLayout::maskRcnn)  // stretched: it gives boxes as shares of its input
        return m_network.run(cv::dnn::blobFromImage(image, 1, letterbox.input(), {}, RED_FIRST),
                             {BOXES, MASKS});
    constexpr double TO_ONE = 1. / std::numeric_limits<uint8_t>::max();
    return m_network.run(cv::dnn::blobFromImage(letterbox.fill(image), TO_ONE, {}, {}, RED_FIRST));
}

OutputLayout SegmentationNetwork::layoutOf(const std::vector<NetworkOutput>& outputs) const
{
    try {
        return recognizeLayout(outputs, m_layout);
    } catch (const InputError& e) {
        throw InputError("the model '" + m_model + "' cannot be used: " + e.what());
    }
}

std::vector<Detection> SegmentationNetwork::detect(const cv::Mat& image,
                                                   const DetectionLimits& limits) const
{
    const Letterbox letterbox(image.size(), inputSizeFor(image.size()));
    const auto outputs = run(image, letterbox);
    return decode(layoutOf(outputs), outputs, letterbox, limits);
}
}  // namespace voxeland
