// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/VoxelizedFrame.h"

#include <vector>

namespace voxeland
{
/** Unprojects a scan's depth pixels and groups them by voxel.
 *  \param sensorPose of the depth camera in the map's frame
 *  \param hits receives the voxels, in order of first pixel
 *  \return all pixels as runs in row-major order, and one more that starts after the last pixel */
std::vector<PixelRun> groupPixels(const mrpt::obs::CObservation3DRangeScan& scan,
                                  const mrpt::poses::CPose3D& sensorPose, double resolution,
                                  const DepthLimits& limits, std::vector<HitVoxel>& hits);
}  // namespace voxeland
