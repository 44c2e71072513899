// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Letterbox.h"
#include "YoloCandidate.h"

namespace voxeland
{
/** Of the candidates of each class that overlap more than allowed, keeps the one with the best
 * score. \return the best first; equal ones in the order they came */
std::vector<YoloCandidate> withoutDuplicates(std::vector<YoloCandidate> candidates,
                                             double maxOverlap);

/** A candidate as a detection in the image. Its mask is where the sum of the prototypes, weighted
 * with its coefficients, enlarged to the image, exceeds the threshold, within its box.
 *  \param prototypes 1 x prototypes x height x width, covering the whole input
 *  \param maskThreshold least probability of a pixel, in (0,1) */
Detection detectionOf(const YoloCandidate& candidate, const cv::Mat& prototypes,
                      const Letterbox& letterbox, double maskThreshold);
}  // namespace voxeland
