// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/level/UpDirection.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
using mrpt::math::TVector3D;

constexpr double DEGREE = M_PI / 180;
constexpr double MAX_TILT = 45 * DEGREE;
constexpr double MIN_TILT = 2 * DEGREE;  //!< less is not worth turning the map
constexpr size_t ENOUGH = 10000;         //!< voxels looked at
constexpr double CLEARLY = 1.1;          //!< how much better than +z a direction near it must be
constexpr double LEAST_SHARE = 0.1;  //!< of all facets that must face up for it to be up: floors
                                     //!< and tables have 0.15 to 0.45, what else there is 0.04
constexpr double FACES_IT = 0.85;    //!< cosine between a facet and a direction that it faces
constexpr double OPTICAL = 8;        //!< how much better than near +z one near -y must be

/** A voxel and where it faces. */
struct Facet
{
    TVector3D position;  //!< [voxel edges]
    TVector3D facing;    //!< unit vector
};

double dot(const TVector3D& a, const TVector3D& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** Away from what is unknown, towards what is free; zero where the surroundings do not tell. */
TVector3D facingOf(const SemanticVoxelMap& map, const VoxelCoord& v)
{
    TVector3D sum(0, 0, 0);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const log_odds_t o = map.occupancy(v + VoxelCoord{x, y, z});
                if (o == UNOBSERVED)
                    sum -= TVector3D(x, y, z);
                else if (OccupancyFilter::isFree(o))
                    sum += TVector3D(x, y, z);
            }
    const double length = sum.norm();
    return length < 3 ? TVector3D(0, 0, 0) : sum * (1 / length);
}

/** Some of the occupied voxels, evenly chosen. */
std::vector<Facet> sampleFacets(const SemanticVoxelMap& map)
{
    size_t voxels = 0;
    map.forEachVoxel([&](const auto&...) { ++voxels; });
    const size_t step = voxels / ENOUGH + 1;
    std::vector<Facet> facets;
    size_t i = 0;
    map.forEachVoxel([&](const VoxelCoord& v, const auto&...) {
        if (i++ % step == 0) facets.push_back({voxelCenter<TVector3D>(v, 1), facingOf(map, v)});
    });
    return facets;
}

/** Sum of squares of the histogram of heights, in bins of one voxel, of what faces a direction.
 * What is MOST_BINS apart shares bins: a map may be spread over millions. */
double concentration(const std::vector<Facet>& facets, const TVector3D& up)
{
    std::vector<double> heights;
    for (const Facet& f : facets)
        if (dot(f.facing, up) > FACES_IT) heights.push_back(dot(f.position, up));
    if (heights.empty()) return 0;
    const double lowest = *std::min_element(heights.begin(), heights.end());
    const double highest = *std::max_element(heights.begin(), heights.end());
    constexpr size_t MOST_BINS = size_t{1} << 14;
    std::vector<double> histogram(std::min(MOST_BINS, static_cast<size_t>(highest - lowest) + 2));
    for (const double h : heights) {
        // Linear share between two bins: no jumps when a plane crosses the border of one.
        const auto bin = static_cast<size_t>(h - lowest);
        const double share = h - lowest - static_cast<double>(bin);
        histogram[bin % histogram.size()] += 1 - share;
        histogram[(bin + 1) % histogram.size()] += share;
    }
    double sum = 0;
    for (const double n : histogram) sum += n * n;
    return sum;
}

/** Whether enough of all that shows where it faces does face a direction. */
bool isFaced(const std::vector<Facet>& facets, const TVector3D& up)
{
    size_t facing = 0, all = 0;
    for (const Facet& f : facets) {
        all += f.facing != TVector3D(0, 0, 0) ? 1 : 0;
        facing += dot(f.facing, up) > FACES_IT ? 1 : 0;
    }
    return static_cast<double>(facing) > LEAST_SHARE * static_cast<double>(all);
}

/** A direction and how good it is. */
struct Candidate
{
    TVector3D up;
    double concentration = 0;
};

/** The best direction within MAX_TILT of an axis, searched from coarse to fine.
 *  \param axis, side1, side2 unit vectors at right angles */
Candidate bestNear(const std::vector<Facet>& facets, const TVector3D& axis, const TVector3D& side1,
                   const TVector3D& side2)
{
    Candidate best{axis, concentration(facets, axis)};
    double best1 = 0, best2 = 0, reach = MAX_TILT;
    for (const double step : {3 * DEGREE, 1 * DEGREE, 0.25 * DEGREE}) {
        const double middle1 = best1, middle2 = best2;
        for (double t1 = middle1 - reach; t1 <= middle1 + reach; t1 += step)
            for (double t2 = middle2 - reach; t2 <= middle2 + reach; t2 += step) {
                const TVector3D v = axis + side1 * std::tan(t1) + side2 * std::tan(t2);
                const TVector3D up = v * (1 / v.norm());
                if (dot(up, axis) < std::cos(MAX_TILT)) continue;
                const double c = concentration(facets, up);
                if (c <= best.concentration) continue;
                best = {up, c};
                best1 = t1;
                best2 = t2;
            }
        reach = step;
    }
    return best;
}
}  // namespace

TVector3D estimateUp(const SemanticVoxelMap& map)
{
    const TVector3D x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const std::vector<Facet> facets = sampleFacets(map);
    // At the end of the search it is a wall that shows, not a floor.
    const auto isFound = [&](const Candidate& c, const TVector3D& axis) {
        return dot(c.up, axis) > std::cos(MAX_TILT - 1 * DEGREE) && isFaced(facets, c.up);
    };
    const Candidate best = bestNear(facets, z, x, y);
    const Candidate optical = bestNear(facets, y * -1.0, x, z);
    if (optical.concentration > OPTICAL * best.concentration && isFound(optical, y * -1.0))
        return optical.up;
    const bool clearlyBetter = best.concentration > CLEARLY * concentration(facets, z);
    return clearlyBetter && best.up.z < std::cos(MIN_TILT) && isFound(best, z) ? best.up : z;
}
}  // namespace voxeland
