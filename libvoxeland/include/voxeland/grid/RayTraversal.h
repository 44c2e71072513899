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
    const std::array<double, 3> from = {origin.x * inverseResolution, origin.y * inverseResolution,
                                        origin.z * inverseResolution};
    const std::array<double, 3> to = {end.x * inverseResolution, end.y * inverseResolution,
                                      end.z * inverseResolution};
    std::array<int32_t, 3> cell{}, step{}, left{};
    std::array<double, 3> next{}, delta{};  // in units of the segment's length
    int32_t steps = 0;
    for (size_t a = 0; a < 3; ++a) {
        cell[a] = static_cast<int32_t>(std::floor(from[a]));
        const int32_t distance = static_cast<int32_t>(std::floor(to[a])) - cell[a];
        step[a] = distance < 0 ? -1 : 1;
        left[a] = std::abs(distance);
        steps += left[a];
        delta[a] = left[a] > 0 ? 1.0 / std::abs(to[a] - from[a]) : 0.0;
        const double toBoundary = distance < 0 ? from[a] - cell[a] : cell[a] + 1 - from[a];
        next[a] = left[a] > 0 ? toBoundary * delta[a] : std::numeric_limits<double>::infinity();
    }
    visit(VoxelCoord{cell[0], cell[1], cell[2]});
    for (; steps > 0; --steps) {
        size_t a = next[0] < next[1] ? 0 : 1;
        if (next[2] < next[a]) a = 2;
        cell[a] += step[a];
        next[a] = --left[a] > 0 ? next[a] + delta[a] : std::numeric_limits<double>::infinity();
        visit(VoxelCoord{cell[0], cell[1], cell[2]});
    }
}
}  // namespace voxeland
