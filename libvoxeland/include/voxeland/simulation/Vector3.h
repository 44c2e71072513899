// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

namespace voxeland::simulation
{
/** A point or direction; metres. MRPT packs it, so whoever holds one after something smaller, and
 * refers to its numbers, aligns it. */
using Vector3 = mrpt::math::TPoint3Df;

inline float dot(const Vector3& a, const Vector3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
}  // namespace voxeland::simulation
