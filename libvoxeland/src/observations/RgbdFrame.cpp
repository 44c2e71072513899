// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/RgbdFrame.h"

#include <Eigen/Dense>

#include <cmath>

namespace voxeland
{
bool isValidPose(const mrpt::poses::CPose3D& pose)
{
    constexpr double FARTHEST = 1e9, TOLERANCE = 0.01;
    for (const double coordinate : pose.m_coords)
        if (!(std::abs(coordinate) < FARTHEST)) return false;
    const auto r = pose.getRotationMatrix().asEigen();
    const double skewness = (r * r.transpose() - Eigen::Matrix3d::Identity()).norm();
    return skewness < TOLERANCE && r.determinant() > 0;
}

mrpt::poses::CPose3D relativeTo(const mrpt::math::TPoint3D& origin,
                                const mrpt::poses::CPose3D& pose)
{
    mrpt::poses::CPose3D moved(pose);
    const auto at = pose.translation() - origin;
    moved.m_coords[0] = at.x;
    moved.m_coords[1] = at.y;
    moved.m_coords[2] = at.z;
    return moved;
}
}  // namespace voxeland
