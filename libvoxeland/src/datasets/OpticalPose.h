// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPose3D.h>
#include <mrpt/poses/CPose3D.h>

#include <array>
#include <optional>

namespace voxeland
{
/** Pose in the world [m, rad] of a camera with MRPT's axes (x forward, y left, z up), from the
 *  matrix datasets give: the camera-to-world transform for optical axes (x right, y down, z
 *  forward).
 *  \param cameraToWorld 4x4, row-major
 *  \return nothing if it is no rigid transform: an entry is not finite, the last row is not 0 0 0
 * 1, or the rotation is off (|R'R - I| > 1e-3, or a reflection) */
std::optional<mrpt::math::TPose3D> poseFromOptical(const std::array<double, 16>& cameraToWorld);

/** The same from a pose of the camera's optical axes. */
mrpt::math::TPose3D poseFromOptical(const mrpt::poses::CPose3D& cameraInWorld);

/** The inverse of poseFromOptical(): pose of the optical axes, given that of the camera. */
mrpt::poses::CPose3D opticalPose(const mrpt::math::TPose3D& pose);
}  // namespace voxeland
