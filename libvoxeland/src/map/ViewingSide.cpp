// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/ViewingSide.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
mrpt::math::TPoint3Df viewingDirection(const mrpt::math::TPoint3Df& camera,
                                       const mrpt::math::TPoint3Df& target)
{
    const auto ray = target - camera;
    const float length = ray.norm();
    return length > 0 ? ray * (1 / length) : mrpt::math::TPoint3Df(0, 0, 1);
}

uint16_t sectorOf(const mrpt::math::TPoint3Df& direction)
{
    const auto step = [](float x) {
        return std::clamp(static_cast<int>(std::lround(2 * x)), -2, 2) + 2;
    };
    return static_cast<uint16_t>((step(direction.x) * 5 + step(direction.y)) * 5 +
                                 step(direction.z));
}

side_t sideOf(const mrpt::math::TPoint3Df& camera, const mrpt::math::TPoint3Df& target)
{
    constexpr int OCTAVES = 16, FIRST = -8;
    const float distance = std::clamp((target - camera).norm(), 1.0F / 256, 255.0F);
    const int octave = std::ilogb(distance) - FIRST;
    return static_cast<side_t>(sectorOf(viewingDirection(camera, target)) * OCTAVES + octave);
}
}  // namespace voxeland
