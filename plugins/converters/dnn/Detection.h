// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/RunLengthMask.h"

#include <opencv2/core/types.hpp>

#include <vector>

namespace voxeland
{
/** Probability or score of each of a network's classes, by class number. */
using ClassScores = std::vector<float>;

/** What a network says of one object, its classes still numbers. */
struct Detection
{
    ClassScores classScores;  //!< of all classes, or 0 for those the network says nothing about
    float score = 0;          //!< that of the most probable class, in [0,1]
    cv::Rect2d box;           //!< in pixels of the image
    RunLengthMask mask;       //!< of the image's size
};

/** Which detections to keep. */
struct DetectionLimits
{
    double score = 0.3;  //!< least score, in [0,1]
    double overlap =
        0.7;            //!< greatest intersection over union of boxes of the same class, in [0,1]
    double mask = 0.5;  //!< least probability of a mask's pixel, in (0,1)
};
}  // namespace voxeland
