// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Detection.h"

#include <vector>

namespace voxeland
{
/** A place where a YOLO network sees an object, before overlaps are sorted out. */
struct YoloCandidate
{
    cv::Rect2d box;                   //!< in pixels of the input
    int topClass = 0;                 //!< number of the most probable class
    float score = 0;                  //!< of that class, in [0,1]
    ClassScores classScores;          //!< of all classes, in [0,1]
    std::vector<float> coefficients;  //!< one for each mask prototype
};
}  // namespace voxeland
