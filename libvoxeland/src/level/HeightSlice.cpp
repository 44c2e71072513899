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
/** Calls f(centre in the gravity-aligned frame) for every observed voxel. */
template <typename F>
void forEachObserved(const SemanticVoxelMap& map, const GravityAlignedFrame& frame, F&& f)
{
    for (const uint32_t b : map.blocks().sorted()) {
        const MapBlock& block = map.blocks()[b];
        for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
            if (block.occupancy(cell) == UNOBSERVED) continue;
            const VoxelCoord v = voxelAt(map.blocks().coordOf(b), cell);
            f(frame.toLevel(voxelCenter<TPoint3D>(v, map.resolution())));
        }
    }
}

/** The part of some heights at which anything was observed. */
HeightRange observedPart(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                         const HeightRange& heights)
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    HeightRange observed{INF, -INF};
    forEachObserved(map, frame, [&](const TPoint3D& p) {
        observed.low = std::min(observed.low, p.z - map.resolution());
        observed.high = std::max(observed.high, p.z + map.resolution());
    });
    return {std::max(heights.low, observed.low), std::min(heights.high, observed.high)};
}

/** An empty grid around everything observed at those heights, on the raster of the voxels. */
HeightSlice frameOf(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                    const HeightRange& heights)
{
    constexpr int NONE = std::numeric_limits<int>::max();
    const double edge = map.resolution();
    int left = NONE, right = -NONE, bottom = NONE, top = -NONE;
    forEachObserved(map, frame, [&](const TPoint3D& p) {
        if (!heights.contains(p.z)) return;
        const int x = voxelIndex(p.x, 1 / edge), y = voxelIndex(p.y, 1 / edge);
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    });
    if (left == NONE)
        throw ConfigurationError("nothing was observed at these heights: choose others");
    HeightSlice slice;
    slice.resolution = edge;
    slice.minX = left * edge;
    slice.minY = bottom * edge;
    slice.columns = static_cast<size_t>(right - left) + 1;
    slice.rows = static_cast<size_t>(top - bottom) + 1;
    return slice;
}

/** The largest occupancy above a place. */
float columnOccupancy(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                      const HeightRange& heights, double x, double y)
{
    const double step = map.resolution() / 2;
    log_odds_t most = UNOBSERVED;
    // Between the voxels' borders, where the frame is not tilted.
    for (double z = (std::ceil(heights.low / step - 0.5) + 0.5) * step; z <= heights.high;
         z += step)
        most = std::max(most, map.occupancyAt(frame.toMap({x, y, z})));
    return static_cast<float>(OccupancyFilter::probability(most));
}
}  // namespace

HeightSlice sliceOf(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                    const HeightRange& heights)
{
    HeightSlice slice = frameOf(map, frame, heights);
    const HeightRange searched = observedPart(map, frame, heights);
    slice.occupancy.reserve(slice.columns * slice.rows);
    for (size_t row = 0; row < slice.rows; ++row)
        for (size_t column = 0; column < slice.columns; ++column)
            slice.occupancy.push_back(
                columnOccupancy(map, frame, searched,
                                slice.minX + (static_cast<double>(column) + 0.5) * slice.resolution,
                                slice.minY + (static_cast<double>(row) + 0.5) * slice.resolution));
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
