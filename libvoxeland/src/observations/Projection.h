// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/img/TCamera.h>

#include <array>

namespace voxeland
{
/** A pixel's coordinates from a direction (x/z, y/z) of optical axes, by the plumb-bob model of
 * OpenCV and MRPT with dist = k1 k2 p1 p2 k3. */
inline std::array<double, 2> projected(const mrpt::img::TCamera& camera, double x, double y)
{
    const auto& d = camera.dist;
    const double r2 = x * x + y * y;
    const double radial = 1 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
    const double u = x * radial + 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x);
    const double v = y * radial + d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y;
    return {camera.cx() + camera.fx() * u, camera.cy() + camera.fy() * v};
}
}  // namespace voxeland
