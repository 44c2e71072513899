// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "UncertainInstance.h"

#include <vector>

namespace voxeland
{
/** Chooses views to show: by size, wholeness and confidence (InstanceView::quality()), sharpness
 * compared with the sharpest, and direction. \param views to choose from, of one category, fetched
 *  \param most number to choose; fewer if there are not as many \param seed of random choice */
std::vector<CandidateView> chooseViews(std::vector<CandidateView> views, size_t most,
                                       ViewSelection how, uint32_t seed);

/** Leaves of an instance's fetched views those to be shown, some for each candidate, and the whole
 * frame of the first of them alone. Views without a picture go. */
void keepChosenViews(UncertainInstance& instance, const DisambiguationOptions& options);
}  // namespace voxeland
