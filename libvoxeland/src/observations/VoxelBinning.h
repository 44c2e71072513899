// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/VoxelizedFrame.h"

#include <vector>

namespace voxeland
{
/** A scan's depth pixels by voxel. */
struct BinnedPixels
{
    std::vector<HitVoxel> hits;    //!< in order of first pixel
    std::vector<HitVoxel> beyond;  //!< see VoxelizedFrame::beyond()
    /** All pixels in row-major order, and one more run that starts after the last pixel. */
    std::vector<PixelRun> runs;
    DepthsMet depths;
};

/** Unprojects a scan's depth pixels and groups them by voxel.
 *  \param sensorPose of the depth camera in the map's frame */
BinnedPixels binPixels(const mrpt::obs::CObservation3DRangeScan& scan,
                       const mrpt::poses::CPose3D& sensorPose, double resolution,
                       const DepthLimits& limits);
}  // namespace voxeland
