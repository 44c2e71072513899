// SPDX-License-Identifier: BSD-3-Clause
#include "OpticalPose.h"

#include "voxeland/observations/PoseAxes.h"

#include <Eigen/Dense>
#include <mrpt/math/CMatrixFixed.h>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
constexpr double TOLERANCE = 1e-3;

bool isRigid(const Eigen::Matrix4d& m)
{
    if (!m.allFinite()) return false;
    if (!m.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), TOLERANCE)) return false;
    const Eigen::Matrix3d r = m.topLeftCorner<3, 3>();
    const Eigen::Matrix3d error = r.transpose() * r - Eigen::Matrix3d::Identity();
    return error.cwiseAbs().maxCoeff() <= TOLERANCE && r.determinant() > 0;
}
}  // namespace

std::optional<mrpt::math::TPose3D> poseFromOptical(const std::array<double, 16>& cameraToWorld)
{
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    const Eigen::Matrix4d m = Eigen::Map<const RowMajor>(cameraToWorld.data());
    if (!isRigid(m)) return std::nullopt;

    return poseFromOptical(mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(m)));
}

mrpt::math::TPose3D poseFromOptical(const mrpt::poses::CPose3D& cameraInWorld)
{
    return (cameraInWorld + -poseOfAxes(PoseAxes::optical)).asTPose();
}

mrpt::poses::CPose3D opticalPose(const mrpt::math::TPose3D& pose)
{
    return mrpt::poses::CPose3D(pose) + poseOfAxes(PoseAxes::optical);
}
}  // namespace voxeland
