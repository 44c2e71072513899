// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/InstanceViews.h"
#include "voxeland/pipeline/DisambiguationOptions.h"

#include <vector>

namespace voxeland
{
/** Chooses views to show. \param views to choose from, of one category
 *  \param most number to choose; fewer if there are not as many \param seed of random choice */
std::vector<InstanceView> chooseViews(std::vector<InstanceView> views, size_t most,
                                      ViewSelection how, uint32_t seed);
}  // namespace voxeland
