// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/GravityAlignedFrame.h"

#include <map>
#include <vector>

namespace voxeland
{
/** Upright box around an object: turned about the direction of up only, as furniture stands. */
struct OrientedBox
{
    mrpt::math::TPoint3D center;  //!< [m]
    mrpt::math::TPoint3D size;    //!< along its own x (the longer side), y, and up [m]
    double yaw =
        0;  //!< from the x axis of the gravity-aligned frame to the box's, in (-pi/2, pi/2] [rad]
    GravityAlignedFrame axes;  //!< the directions of its sides, the last one being up
};

/** The box around the main part of an object, in the map's frame: the upright box whose rectangle
 * in the plan has the least area, its x axis along the longer side; of equal ones, the one turned
 * least. The main part are the connected parts (by faces, edges or corners of voxels) that have at
 * least a tenth as many voxels as the largest: stray voxels do not stretch the box. It encloses the
 * voxels' centres, and half an edge is added on each side. \param voxels not empty \param
 * resolution edge [m] \param frame tells what is horizontal */
OrientedBox orientedBox(const std::vector<VoxelCoord>& voxels, double resolution,
                        const GravityAlignedFrame& frame = GravityAlignedFrame());

/** The boxes of all instances that win at least one occupied voxel, around those voxels, in the
 *  world.
 *  \param frame tells what is horizontal */
std::map<instance_id_t, OrientedBox> orientedBoxes(const SemanticVoxelMap& map,
                                                   const GravityAlignedFrame& frame);
}  // namespace voxeland
