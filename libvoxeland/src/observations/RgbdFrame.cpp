// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/RgbdFrame.h"

#include "voxeland/grid/VoxelCoord.h"

#include <cmath>

namespace voxeland
{
bool isValidPose(const mrpt::poses::CPose3D& pose)
{
    constexpr double FARTHEST = MAX_VOXEL_COORD * 0.001;
    for (int row = 0; row < 3; ++row) {
        if (!(std::abs(pose.m_coords[static_cast<size_t>(row)]) < FARTHEST)) return false;
        for (int col = 0; col < 3; ++col)
            if (!std::isfinite(pose.getRotationMatrix()(row, col))) return false;
    }
    return true;
}
}  // namespace voxeland
