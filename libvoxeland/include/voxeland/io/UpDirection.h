// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

namespace voxeland
{
/** Where up is in a map, as a unit vector. Floor, tables and ceiling pile voxels up at few heights:
 *  of all directions within 45 degrees of the map's z axis, the one whose histogram of heights is
 *  the most concentrated. Worlds that start in a tilted camera are levelled by it; +z, exactly,
 *  wherever no direction is clearly better. Deterministic. */
mrpt::math::TVector3D estimateUp(const SemanticVoxelMap& map);
}  // namespace voxeland
