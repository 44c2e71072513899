// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseUncertainty.h"

#include "voxeland/base/errors.h"

#include <Eigen/Dense>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>
#include <limits>

using mrpt::math::CMatrixDouble66;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

namespace voxeland
{
namespace
{
void check(const CMatrixDouble66& covariance)
{
    bool valid = true;
    for (int row = 0; row < 6; ++row) {
        valid = valid && covariance(row, row) >= 0;
        for (int col = 0; col < 6; ++col) valid = valid && std::isfinite(covariance(row, col));
    }
    if (!valid)
        throw InputError(
            "a pose has a covariance with negative variances or with elements that are not numbers:"
            " correct it, or set pose_uncertainty = false in [map]");
}

/** Maps errors (x, y, z, yaw, pitch, roll) of a pose to (dt, dw). */
CMatrixDouble66 toRotationVector(const mrpt::poses::CPose3D& pose)
{
    const double yaw = pose.yaw();
    const auto& R = pose.getRotationMatrix();
    CMatrixDouble66 J = CMatrixDouble66::Identity();
    const std::array<TVector3D, 3> axes = {
        {{0, 0, 1}, {-std::sin(yaw), std::cos(yaw), 0}, {R(0, 0), R(1, 0), R(2, 0)}}};
    for (int row = 0; row < 3; ++row)
        for (int col = 0; col < 3; ++col)
            J(3 + row, 3 + col) = axes[static_cast<size_t>(col)][static_cast<size_t>(row)];
    return J;
}
}  // namespace

PoseUncertainty::PoseUncertainty(const mrpt::poses::CPose3D& pose,
                                 const CMatrixDouble66& covariance)
    : m_origin(pose.translation())
{
    check(covariance);
    const CMatrixDouble66 J = toRotationVector(pose);
    CMatrixDouble66 S;
    S = J.asEigen() * covariance.asEigen() * J.asEigen().transpose();
    m_translation = S(0, 0) + S(1, 1) + S(2, 2);
    m_mixed = {S(1, 5) - S(2, 4), S(2, 3) - S(0, 5), S(0, 4) - S(1, 3)};
    const double trace = S(3, 3) + S(4, 4) + S(5, 5);
    for (int row = 0; row < 3; ++row)
        for (int col = 0; col < 3; ++col)
            m_rotation[static_cast<size_t>(row)][static_cast<size_t>(col)] =
                (row == col ? trace : 0) - S(3 + row, 3 + col);
}

double PoseUncertainty::displacement(const TPoint3D& point) const
{
    const auto dot = [](const TVector3D& a, const TVector3D& b) {
        return a.x * b.x + a.y * b.y + a.z * b.z;
    };
    const TVector3D u = point - m_origin;
    const TVector3D turned(dot(m_rotation[0], u), dot(m_rotation[1], u), dot(m_rotation[2], u));
    const double squared = m_translation + 2 * dot(m_mixed, u) + dot(turned, u);
    if (!std::isfinite(squared)) return std::numeric_limits<double>::infinity();
    return std::sqrt(std::max(0.0, squared));
}
}  // namespace voxeland
