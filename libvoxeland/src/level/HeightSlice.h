// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/GravityAlignedFrame.h"

#include <string>
#include <vector>

namespace mrpt::maps
{
class COccupancyGridMap2D;
}

namespace voxeland
{
/** A level layer of a map as a flat grid, for robots that drive. */
struct HeightSlice
{
    double resolution = 0;         //!< edge of a cell [m]
    double minX = 0, minY = 0;     //!< corner of the first cell in the gravity-aligned frame [m]
    size_t columns = 0, rows = 0;  //!< along x and y
    /** Probability of occupied, rows of increasing y; 0.5: never observed. */
    std::vector<float> occupancy;
};

/** Looks through the heights: of the voxels above one another in a cell, the one most likely
 *  occupied decides. The grid covers everything observed at those heights.
 *  \param heights in the gravity-aligned frame [m]
 *  \throws ConfigurationError if nothing was observed there, or the grid would be of more than 100
 *  million cells */
HeightSlice sliceOf(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                    const HeightRange& heights);

/** The same slice, its corner in the world: in the gravity-aligned frame it is counted from the
 * map's origin.
 */
HeightSlice inWorld(HeightSlice slice, const SemanticVoxelMap& map);

/** A slice for MRPT's planners, in the frame of the slice.
 *  \throws ConfigurationError where floats lack the digits for its place */
mrpt::maps::COccupancyGridMap2D gridOf(const HeightSlice& slice);
}  // namespace voxeland
