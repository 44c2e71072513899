// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Detection.h"

#include <opencv2/core.hpp>

namespace voxeland
{
/** Reads the outputs of TensorFlow's Mask R-CNN networks.
 *  \param boxes `detection_out_final`: 1 x 1 x objects x 7, each batch, class, score, left, top,
 *  right and bottom, the last four as shares of the image
 *  \param masks `detection_masks`: objects x classes x height x width, for each class the
 *  probability that a pixel belongs to the object, spread over its box */
std::vector<Detection> detectionsOfMaskRcnn(const cv::Mat& boxes, const cv::Mat& masks,
                                            const cv::Size& image, const DetectionLimits& limits);
}  // namespace voxeland
