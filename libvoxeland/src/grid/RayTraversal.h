// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace voxeland
{
/** The way of a straight segment through voxels (Amanatides and Woo, "A fast voxel traversal
 *  algorithm for ray tracing", 1987): each step crosses the boundary that comes next, and so many
 *  steps lead from the voxel of the segment's origin to that of its end. Times are fixed-point
 *  numbers, the whole segment taking 2^52. */
struct GridRay
{
    std::array<int32_t, 3> cell{};   //!< voxel of the origin
    std::array<int32_t, 3> step{};   //!< 1 or -1
    std::array<int64_t, 3> next{};   //!< when each axis' next boundary is crossed
    std::array<int64_t, 3> delta{};  //!< time between crossings of an axis
    int32_t steps = 0;               //!< number of boundaries crossed, of all axes

    /** \param origin,end metric points with x, y, z
     *  \param inverseResolution 1/edge [1/m] */
    template <typename Point>
    GridRay(const Point& origin, const Point& end, double inverseResolution)
    {
        constexpr double ONE = 4503599627370496.0;  // 2^52
        constexpr int64_t NEVER = int64_t{1} << 62;
        const std::array<double, 3> from = {origin.x * inverseResolution,
                                            origin.y * inverseResolution,
                                            origin.z * inverseResolution};
        const std::array<double, 3> to = {end.x * inverseResolution, end.y * inverseResolution,
                                          end.z * inverseResolution};
        std::array<int32_t, 3> crossings{};
        int64_t last = 0;
        for (size_t a = 0; a < 3; ++a) {
            cell[a] = static_cast<int32_t>(std::floor(from[a]));
            const int32_t distance = static_cast<int32_t>(std::floor(to[a])) - cell[a];
            step[a] = distance < 0 ? -1 : 1;
            crossings[a] = std::abs(distance);
            steps += crossings[a];
            next[a] = NEVER;
            if (distance == 0) continue;
            const double period = ONE / std::abs(to[a] - from[a]);
            const double toBoundary = distance < 0 ? from[a] - cell[a] : cell[a] + 1 - from[a];
            delta[a] = static_cast<int64_t>(std::min(ONE, period));
            next[a] = static_cast<int64_t>(std::min(ONE, toBoundary * period));
            last = std::max(last, next[a] + (crossings[a] - 1) * delta[a]);
        }
        // Rounding must not let an axis cross one boundary more before the others are through.
        for (size_t a = 0; a < 3; ++a)
            next[a] = std::max(next[a], last + 1 - crossings[a] * delta[a]);
    }
};

/** Visits, in order, every voxel that the straight segment from `origin` to `end` passes through,
 *  that of `origin` first and that of `end` last. Successive voxels share a face.
 *
 *  \param origin,end metric points with x, y, z
 *  \param inverseResolution 1/edge [1/m]
 *  \param visit called as visit(VoxelCoord) */
template <typename Point, typename Visitor>
void traverseRay(const Point& origin, const Point& end, double inverseResolution, Visitor&& visit)
{
    auto [cell, step, next, delta, steps] = GridRay(origin, end, inverseResolution);
    visit(VoxelCoord{cell[0], cell[1], cell[2]});
    for (; steps > 0; --steps) {
        const size_t x = 0, y = 1, z = 2;
        const size_t axis = next[x] < next[y] && next[x] <= next[z] ? x
                            : next[y] <= next[z]                    ? y
                                                                    : z;
        cell[axis] += step[axis];
        next[axis] += delta[axis];
        visit(VoxelCoord{cell[x], cell[y], cell[z]});
    }
}
}  // namespace voxeland
