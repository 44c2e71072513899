// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/ObservedSpace.h"
#include "voxeland/observations/Opinion.h"
#include "voxeland/pipeline/StageTimes.h"

#include <mrpt/core/Clock.h>

#include <optional>
#include <vector>

namespace voxeland
{
/** All that can be computed of a frame without the map; several frames can be prepared at once. */
struct PreparedFrame
{
    VoxelizedFrame voxels;
    std::vector<Opinion> opinions;
    ObservedSpace space;
    bool hasPredictions = false;  //!< whether the rawlog had predictions for the frame
    StageTimes times;
    mrpt::Clock::time_point time{};  //!< timestamp of the frame
    /** By how much its evidence is discounted: not at all where this is absent. */
    std::optional<PoseUncertainty> uncertainty{};
};
}  // namespace voxeland
