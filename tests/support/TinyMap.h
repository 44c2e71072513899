// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <map>
#include <string>

namespace voxeland::test
{
constexpr double TINY_RESOLUTION = 0.1;

/** A map of 0.1 m voxels, without a prior. */
inline SemanticVoxelMap emptyMap()
{
    MapOptions options;
    options.resolution = TINY_RESOLUTION;
    options.prior_strength = 0;
    return SemanticVoxelMap(options);
}

/** Adds an instance with this category evidence. */
inline instance_id_t addInstance(SemanticVoxelMap& map, const std::map<std::string, double>& beta)
{
    Instance& instance = map.createInstance();
    for (const auto& [name, b] : beta) instance.categories.add(map.categories().add(name), b);
    instance.observations = 3;
    return instance.id;
}

/** Evidence in a voxel that is occupied with this probability. */
inline void addVoxel(SemanticVoxelMap& map, const VoxelCoord& v,
                     const std::map<instance_id_t, float>& alpha, double occupancy = 0.9)
{
    for (const auto& [id, a] : alpha) map.addEvidence(v, id, a);
    map.blocks()
        .at(blockOf(v))
        .setOccupancy(cellOf(v), OccupancyFilter::fromProbability(occupancy));
}

/** Four voxels whose numbers are known by hand:
 *  - (0,0,0): instance 1 (chair 2, table 2) with alpha 10, unknown with 1;
 *  - (1,0,0): instance 2 (cup 3) with alpha 1, unknown with 1;
 *  - (-1,-1,-1): unknown only;
 *  - (5,5,5): instance 2, but believed free now. */
inline SemanticVoxelMap tinyMap()
{
    SemanticVoxelMap map = emptyMap();
    const instance_id_t seat = addInstance(map, {{"chair", 2}, {"table", 2}});
    const instance_id_t cup = addInstance(map, {{"cup", 3}});
    addVoxel(map, {0, 0, 0}, {{seat, 10}, {UNKNOWN_INSTANCE, 1}});
    addVoxel(map, {1, 0, 0}, {{cup, 1}, {UNKNOWN_INSTANCE, 1}}, 0.8);
    addVoxel(map, {-1, -1, -1}, {{UNKNOWN_INSTANCE, 4}});
    addVoxel(map, {5, 5, 5}, {{cup, 1}}, 0.2);
    return map;
}

/** \name The entropies of tinyMap() [nat]
 * Expected entropies of Dirichlets in closed form: with integer parameters digamma differences are
 * sums of reciprocals, psi(A+1) - psi(a+1) = 1/(a+1) + ... + 1/A. Semantic ones by hand from
 * p = (5/11, 5/11, 1/11) and (1/2, 1/2). @{ */
constexpr double H_INSTANCE_10_1 = (10.0 / 11) * (1.0 / 11) +        // a = 10 of A = 11
                                   (1.0 / 11) * 2.0198773448773446;  // a = 1: H_11 - 1
constexpr double H_INSTANCE_1_1 = 0.5;
constexpr double H_CATEGORY_2_2 = 1.0 / 3 + 1.0 / 4;
constexpr double H_SEMANTIC_SEAT = 0.934770, H_SEMANTIC_CUP = 0.693147;
/** @} */
}  // namespace voxeland::test
