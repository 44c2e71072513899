// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/UpDirection.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
using mrpt::math::TVector3D;
using points_t = std::vector<TVector3D>;

constexpr double DEGREE = M_PI / 180;
constexpr double MAX_TILT = 45 * DEGREE;
constexpr size_t ENOUGH = 5000;          //!< points looked at
constexpr double CLEARLY = 1.1;          //!< how much better than +z another direction must be
constexpr double MIN_TILT = 2 * DEGREE;  //!< less is not worth turning the map

/** Some of the occupied voxels, evenly chosen, in voxel edges. */
points_t samplePoints(const SemanticVoxelMap& map)
{
    points_t all;
    map.forEachVoxel(
        [&](const VoxelCoord& v, const auto&...) { all.push_back(voxelCenter<TVector3D>(v, 1)); });
    const size_t step = all.size() / ENOUGH + 1;
    points_t some;
    for (size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    return some;
}

/** Unit vector tilted from +z. \param tx, ty its rise towards x and y [rad] */
TVector3D tilted(double tx, double ty)
{
    const TVector3D v(std::tan(tx), std::tan(ty), 1);
    return v * (1 / v.norm());
}

/** Sum of squares of the heights' histogram, in bins of one voxel. */
double concentration(const points_t& points, const TVector3D& up)
{
    std::vector<double> heights;
    for (const auto& p : points) heights.push_back(up.x * p.x + up.y * p.y + up.z * p.z);
    const double lowest = *std::min_element(heights.begin(), heights.end());
    std::vector<double> histogram;
    for (const double h : heights) {
        // Linear share between two bins: no jumps when a plane crosses the border of one.
        const auto bin = static_cast<size_t>(h - lowest);
        const double share = h - lowest - static_cast<double>(bin);
        if (histogram.size() < bin + 2) histogram.resize(bin + 2);
        histogram[bin] += 1 - share;
        histogram[bin + 1] += share;
    }
    double sum = 0;
    for (const double n : histogram) sum += n * n;
    return sum;
}
}  // namespace

TVector3D estimateUp(const SemanticVoxelMap& map)
{
    const TVector3D z(0, 0, 1);
    const points_t points = samplePoints(map);
    if (points.empty()) return z;

    // From coarse to fine around the best so far.
    double bestX = 0, bestY = 0, best = concentration(points, z);
    const double ofZ = best;
    double reach = MAX_TILT;
    for (const double step : {3 * DEGREE, 1 * DEGREE, 0.25 * DEGREE}) {
        const double x0 = bestX, y0 = bestY;
        for (double tx = x0 - reach; tx <= x0 + reach; tx += step)
            for (double ty = y0 - reach; ty <= y0 + reach; ty += step) {
                const TVector3D up = tilted(tx, ty);
                if (up.z < std::cos(MAX_TILT)) continue;
                const double c = concentration(points, up);
                if (c <= best) continue;
                best = c;
                bestX = tx;
                bestY = ty;
            }
        reach = step;
    }
    const TVector3D up = tilted(bestX, bestY);
    return best > CLEARLY * ofZ && up.z < std::cos(MIN_TILT) ? up : z;
}
}  // namespace voxeland
