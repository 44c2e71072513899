// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <array>
#include <cmath>
#include <limits>

namespace voxeland
{
/** Visits, in order, every voxel that the straight segment from `origin` to `end` passes through,
 *  that of `origin` first and that of `end` last (Amanatides and Woo, "A fast voxel traversal
 *  algorithm for ray tracing", 1987). Successive voxels share a face. The number of steps along
 *  each axis is fixed beforehand, so that rounding can never miss the last voxel.
 *
 *  \param origin,end metric points with x, y, z
 *  \param inverseResolution 1/edge [1/m]
 *  \param visit called as visit(VoxelCoord) */
template <typename Point, typename Visitor>
void traverseRay(const Point& origin, const Point& end, double inverseResolution, Visitor&& visit)
{
    // Times of boundary crossings along the segment, in fixed point: integer arithmetic without
    // branches takes a third of the time that a branch per step costs, since the axis cannot be
    // predicted.
    constexpr double ONE = 4503599627370496.0;  // 2^52: the whole segment
    constexpr int64_t NEVER = std::numeric_limits<int64_t>::max() / 2;
    const std::array<double, 3> from = {origin.x * inverseResolution, origin.y * inverseResolution,
                                        origin.z * inverseResolution};
    const std::array<double, 3> to = {end.x * inverseResolution, end.y * inverseResolution,
                                      end.z * inverseResolution};
    std::array<int32_t, 3> cell{}, step{}, left{};
    std::array<int64_t, 3> next{}, delta{};
    for (size_t a = 0; a < 3; ++a) {
        cell[a] = static_cast<int32_t>(std::floor(from[a]));
        const int32_t distance = static_cast<int32_t>(std::floor(to[a])) - cell[a];
        step[a] = distance < 0 ? -1 : 1;
        left[a] = std::abs(distance);
        const double crossing = left[a] > 0 ? ONE / std::abs(to[a] - from[a]) : 0.0;
        const double toBoundary = distance < 0 ? from[a] - cell[a] : cell[a] + 1 - from[a];
        delta[a] = static_cast<int64_t>(crossing);
        next[a] = left[a] > 0 ? static_cast<int64_t>(toBoundary * crossing) : NEVER;
    }
    VoxelCoord v = {cell[0], cell[1], cell[2]};
    visit(v);
    const auto [stepX, stepY, stepZ] = step;
    const auto [deltaX, deltaY, deltaZ] = delta;
    auto [leftX, leftY, leftZ] = left;
    auto [nextX, nextY, nextZ] = next;
    for (int32_t steps = leftX + leftY + leftZ; steps > 0; --steps) {
        const auto x = static_cast<int32_t>(nextX < nextY) & static_cast<int32_t>(nextX <= nextZ);
        const auto y = (x ^ 1) & static_cast<int32_t>(nextY <= nextZ);
        const auto z = (x | y) ^ 1;
        v.x += stepX & -x;
        v.y += stepY & -y;
        v.z += stepZ & -z;
        leftX -= x;
        leftY -= y;
        leftZ -= z;
        nextX = leftX > 0 ? nextX + (deltaX & -static_cast<int64_t>(x)) : NEVER;
        nextY = leftY > 0 ? nextY + (deltaY & -static_cast<int64_t>(y)) : NEVER;
        nextZ = leftZ > 0 ? nextZ + (deltaZ & -static_cast<int64_t>(z)) : NEVER;
        visit(v);
    }
}
}  // namespace voxeland
