// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

namespace voxeland
{
/** Where up is in a map, as a unit vector. Floor and tables face up (there is free space on that
 *  side, and none was seen on the other) and lie at few heights: of all directions within 45
 *  degrees of the map's z axis, the one for which the histogram of the heights of the voxels that
 *  face it is the most concentrated. Worlds that start in a tilted camera are levelled by it; +z,
 *  exactly, wherever no direction is clearly better, or less than a tenth of what shows where it
 * faces does face it (only walls were seen, say). A world with a camera's optical axes (y down) is
 * recognized where hardly anything faces +z, but much faces -y. Deterministic. */
mrpt::math::TVector3D estimateUp(const SemanticVoxelMap& map);
}  // namespace voxeland
