// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland::test
{
/** Makes a voxel one in which points were measured, of this occupancy. */
inline void setVoxel(SemanticVoxelMap& map, const VoxelCoord& v, double probability = 0.9)
{
    map.addEvidence(v, UNKNOWN_INSTANCE, 1);
    map.blocks()
        .at(blockOf(v))
        .setOccupancy(cellOf(v), OccupancyFilter::fromProbability(probability));
}
}  // namespace voxeland::test
