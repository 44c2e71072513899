// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/GravityAlignedFrame.h"

#include <mrpt/poses/CPose3D.h>

#include <vector>

namespace voxeland
{
/** A camera carried through the place of a map. */
struct CarriedCamera
{
    double height = 1.2;          //!< above the floor [m]
    double horizontalAngle = 58;  //!< of view [deg]; 58 and 45 are common among RGB-D cameras
    double verticalAngle = 45;    //!< of view [deg]
    double bodyRadius = 0.2;      //!< of who carries it [m]
    double minDistance = 0.6;     //!< to the middle of what it looks at [m]
    double maxDistance = 4;       //!< beyond, depth cameras are of little use [m]
};

/** A place to look at something from. */
struct CameraPose
{
    mrpt::poses::CPose3D pose;  //!< in the map's frame; x ahead, y to the left, z up
    double yaw = 0,
           pitch = 0;  //!< in the gravity-aligned frame [rad]; as MRPT counts: pitch > 0 looks down
    double distance = 0;  //!< to the middle of what is looked at [m]
    double visible = 0;   //!< share of its voxels that nothing hides, (0,1]
};

/** Finds places from which some voxels are well seen. The camera stands in observed free space, at
 *  its height above the floor, and nothing occupied is where its bearer would be; it looks at the
 *  middle of the voxels from where they just fit into the picture. A voxel is visible if the ray to
 *  it stays in observed free space until it meets one of them.
 *  \param floor its height in the gravity-aligned frame [m], see floorHeight()
 *  \param voxels what to look at, not empty
 *  \param most how many places to give: those that see most of the voxels, and at least 45 degrees
 *  apart as seen from these; fewer, or none, if there are no others */
std::vector<CameraPose> placeCamera(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                                    const CarriedCamera& camera, double floor,
                                    const std::vector<VoxelCoord>& voxels, size_t most = 3);
}  // namespace voxeland
