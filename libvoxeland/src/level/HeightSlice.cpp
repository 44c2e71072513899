// SPDX-License-Identifier: BSD-3-Clause
#include "HeightSlice.h"

#include "files/FloatDigits.h"
#include "voxeland/base/errors.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
/** Calls f(voxel, centre in the gravity-aligned frame, log-odds) for every observed voxel. */
template <typename F>
void forEachObserved(const SemanticVoxelMap& map, const GravityAlignedFrame& frame, F&& f)
{
    for (const uint32_t b : map.blocks().sorted()) {
        const MapBlock& block = map.blocks()[b];
        for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
            if (block.occupancy(cell) == UNOBSERVED) continue;
            const VoxelCoord v = voxelAt(map.blocks().coordOf(b), cell);
            f(v, frame.toLevel(voxelCenter<TPoint3D>(v, map.resolution())), block.occupancy(cell));
        }
    }
}

/** An empty grid around everything observed at those heights, on the raster of the voxels. */
HeightSlice frameOf(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                    const HeightRange& heights)
{
    constexpr int64_t NONE = std::numeric_limits<int64_t>::max(), MOST_CELLS = 100000000;
    const double edge = map.resolution();
    int64_t left = NONE, right = -NONE, bottom = NONE, top = -NONE;
    forEachObserved(map, frame, [&](const VoxelCoord&, const TPoint3D& p, log_odds_t) {
        if (!heights.contains(p.z)) return;
        const int64_t x = voxelIndex(p.x, 1 / edge), y = voxelIndex(p.y, 1 / edge);
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    });
    if (left == NONE)
        throw ConfigurationError("nothing was observed at these heights: choose others");
    const int64_t columns = right - left + 1, rows = top - bottom + 1;
    if (columns > MOST_CELLS / rows)
        throw ConfigurationError("a grid of " + std::to_string(columns) + " x " +
                                 std::to_string(rows) +
                                 " cells would be larger than 100 million: map at a coarser "
                                 "resolution, or choose heights at which less was observed");
    HeightSlice slice;
    slice.resolution = edge;
    slice.minX = static_cast<double>(left) * edge;
    slice.minY = static_cast<double>(bottom) * edge;
    slice.columns = static_cast<size_t>(columns);
    slice.rows = static_cast<size_t>(rows);
    return slice;
}

/** Numbers of the places (number + 1/2) * step from `begin` on that are near a point of an axis. */
struct Near
{
    double first, last;
    Near(double point, double reach, double begin, double step)
        : first(std::ceil((point - reach - begin) / step - 0.5)),
          last(std::floor((point + reach - begin) / step - 0.5))
    {
    }
};
}  // namespace

HeightSlice sliceOf(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                    const HeightRange& heights)
{
    HeightSlice slice = frameOf(map, frame, heights);
    std::vector<log_odds_t> most(slice.columns * slice.rows, UNOBSERVED);
    // Places are looked up above the middle of each cell, between the voxels' borders where the
    // frame is not tilted. A voxel is told to those it holds: what is empty costs nothing.
    const double edge = slice.resolution, step = edge / 2, reach = edge * std::sqrt(3) / 2;
    forEachObserved(map, frame, [&](const VoxelCoord& v, const TPoint3D& p, log_odds_t log) {
        if (p.z + reach < heights.low || p.z - reach > heights.high) return;
        const Near xs(p.x, reach, slice.minX, edge), ys(p.y, reach, slice.minY, edge),
            zs(p.z, reach, 0, step);
        const auto holds = [&](double column, double row) {
            TPoint3D place(slice.minX + (column + 0.5) * edge, slice.minY + (row + 0.5) * edge, 0);
            for (double k = zs.first; k <= zs.last; ++k) {
                place.z = (k + 0.5) * step;
                if (heights.contains(place.z) && voxelOf(frame.toMap(place), 1 / edge) == v)
                    return true;
            }
            return false;
        };
        for (double row = std::max(0.0, ys.first);
             row <= ys.last && row < static_cast<double>(slice.rows); ++row)
            for (double column = std::max(0.0, xs.first);
                 column <= xs.last && column < static_cast<double>(slice.columns); ++column)
            {
                log_odds_t& cell =
                    most[static_cast<size_t>(row) * slice.columns + static_cast<size_t>(column)];
                if (cell < log && holds(column, row)) cell = log;
            }
    });
    slice.occupancy.reserve(most.size());
    for (const log_odds_t log : most)
        slice.occupancy.push_back(static_cast<float>(OccupancyFilter::probability(log)));
    return slice;
}

HeightSlice inWorld(HeightSlice slice, const SemanticVoxelMap& map)
{
    slice.minX += map.origin().x;
    slice.minY += map.origin().y;
    return slice;
}

mrpt::maps::COccupancyGridMap2D gridOf(const HeightSlice& slice)
{
    const auto columns = static_cast<double>(slice.columns), rows = static_cast<double>(slice.rows);
    const auto at = [&](double metres) { return asFloat(metres, slice.resolution, "a gridmap"); };
    mrpt::maps::COccupancyGridMap2D grid(
        at(slice.minX), at(slice.minX + columns * slice.resolution), at(slice.minY),
        at(slice.minY + rows * slice.resolution), static_cast<float>(slice.resolution));
    for (size_t row = 0; row < slice.rows; ++row)
        for (size_t column = 0; column < slice.columns; ++column)
            grid.setCell(static_cast<int>(column), static_cast<int>(row),
                         1 - slice.occupancy[row * slice.columns + column]);
    return grid;
}
}  // namespace voxeland
