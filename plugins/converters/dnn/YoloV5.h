// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "YoloCandidate.h"

#include <opencv2/core.hpp>

namespace voxeland
{
/** Reads the output of Ultralytics' YOLO v5 segmentation networks: 1 x places x (5 + classes +
 * prototypes). In each row: centre and size of the box in input pixels, how sure the network is of
 * an object, scores of the classes given that there is one, coefficients of the mask.
 *  \param minScore places whose best class scores less, times that of the object, are left out */
std::vector<YoloCandidate> candidatesOfYoloV5(const cv::Mat& output, int prototypes,
                                              double minScore);
}  // namespace voxeland
