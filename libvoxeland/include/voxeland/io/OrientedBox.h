// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

#include <map>
#include <vector>

namespace voxeland
{
/** Upright box around an object: turned about the map's z axis only, as furniture stands. */
struct OrientedBox
{
    mrpt::math::TPoint3D center;  //!< [m]
    mrpt::math::TPoint3D size;    //!< along its own x (the longer spread), y, and z [m]
    double yaw = 0;               //!< from the map's x axis to the box's, in (-pi/2, pi/2] [rad]
};

/** The box around these voxels. Its x axis is the direction in which the voxels' centres spread
 *  most in the horizontal plane (principal component); half a voxel is added on each side.
 *  \param voxels not empty \param resolution edge [m] */
OrientedBox orientedBox(const std::vector<VoxelCoord>& voxels, double resolution);

/** The boxes of all instances that win at least one occupied voxel, around those voxels. */
std::map<instance_id_t, OrientedBox> orientedBoxes(const SemanticVoxelMap& map);
}  // namespace voxeland
