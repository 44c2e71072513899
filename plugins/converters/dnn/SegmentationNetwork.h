// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Network.h"
#include "OutputLayout.h"

#include <string>
#include <vector>

namespace voxeland
{
/** A network that finds objects with their masks in images. */
class SegmentationNetwork
{
 public:
    /** \param layout automatic: to be recognized
     *  \param input size of the network's input; sides that are 0: the model says, otherwise 640
     * or, for Mask R-CNN, as the image's [pixels] \throws InputError if the network cannot be used,
     * ConfigurationError if it has another size of input */
    SegmentationNetwork(const NetworkFiles& files, const NetworkDevice& device, OutputLayout layout,
                        const cv::Size& input);

    [[nodiscard]] OutputLayout layout() const { return m_layout; }
    /** How many classes it tells apart; 0 if that shows only when it sees an image. */
    [[nodiscard]] int classes() const { return m_classes; }
    /** Names of the classes that the model holds; may be empty. */
    [[nodiscard]] const std::vector<std::string>& classNames() const
    {
        return m_network.classNames();
    }

    /** What it finds; thread safe, one image after another.
     *  \param image of 8 bits: blue, green and red
     *  \throws InputError if the network cannot be run, or its outputs cannot be read */
    [[nodiscard]] std::vector<Detection> detect(const cv::Mat& image,
                                                const DetectionLimits& limits) const;

 private:
    [[nodiscard]] cv::Size inputSizeFor(const cv::Size& image) const;
    [[nodiscard]] std::vector<NetworkOutput> run(const cv::Mat& image,
                                                 const Letterbox& letterbox) const;
    [[nodiscard]] OutputLayout layoutOf(const std::vector<NetworkOutput>& outputs) const;

    std::string m_model;
    Network m_network;
    OutputLayout m_layout;
    cv::Size m_input;
    int m_classes = 0;
};
}  // namespace voxeland
