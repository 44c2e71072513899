// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/rawlogs/RawlogFrameSource.h"

#include <functional>
#include <set>

namespace voxeland
{
/** Maps all frames of a rawlog, which are read and prepared ahead in several threads.
 *  \param onFrame called after each frame with its timestamp and stage times
 *  \throws InputError as RawlogFrameSource and SemanticMapper do; NothingToMapError if there is no
 * frame with a pose. The map then holds the frames before. */
void mapRawlog(
    RawlogFrameSource& source, CVoxelandMap& map,
    const std::function<void(const mrpt::Clock::time_point&, const StageTimes&)>& onFrame);

/** Timestamps of the frames that a map is known to hold: those of which it keeps views. */
std::set<mrpt::Clock::time_point> timesOfViews(const SemanticVoxelMap& map);
}  // namespace voxeland
