// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "UncertainInstance.h"

#include <vector>

namespace voxeland
{
/** Chooses views to show, good ones, each from another side: the best by size, wholeness and
 *  confidence (InstanceView::quality()) times sharpness compared with the sharpest, then those of
 *  the greatest product of that and the angle to the nearest chosen one, up to 90 degrees.
 *  \param views to choose from, of one category, fetched
 *  \param most number to choose; fewer if there are not as many */
std::vector<CandidateView> chooseViews(std::vector<CandidateView> views, size_t most);

/** Leaves of an instance's fetched views those to be shown, some for each candidate, and the whole
 * frame of the first of them alone. Views without a picture go. */
void keepChosenViews(UncertainInstance& instance, const DisambiguationOptions& options);
}  // namespace voxeland
