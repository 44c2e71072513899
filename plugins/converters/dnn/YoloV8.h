// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "YoloCandidate.h"

#include <opencv2/core.hpp>

namespace voxeland
{
/** Reads the output of Ultralytics' YOLO v8 and v11 segmentation networks: 1 x (4 + classes +
 * prototypes) x places. Down each column: centre and size of the box in input pixels, scores of the
 * classes, coefficients of the mask.
 *  \param minScore places whose best class scores less are left out */
std::vector<YoloCandidate> candidatesOfYoloV8(const cv::Mat& output, int prototypes,
                                              double minScore);
}  // namespace voxeland
