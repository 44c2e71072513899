// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <random>
#include <vector>

namespace voxeland::test
{
/** Ids of the live instances. */
inline std::vector<instance_id_t> liveIds(const SemanticVoxelMap& map)
{
    std::vector<instance_id_t> ids;
    for (const auto& [id, instance] : map.instances()) ids.push_back(id);
    return ids;
}

/** One of the live instances, or UNKNOWN_INSTANCE if there is none. */
inline instance_id_t anyInstance(const SemanticVoxelMap& map, std::mt19937& random)
{
    const auto ids = liveIds(map);
    if (ids.empty()) return UNKNOWN_INSTANCE;
    return ids[std::uniform_int_distribution<size_t>(0, ids.size() - 1)(random)];
}

/** Voxels with evidence for an instance. */
inline std::vector<VoxelCoord> voxelsOf(const SemanticVoxelMap& map, instance_id_t id)
{
    std::vector<VoxelCoord> voxels;
    map.forEachVoxel(
        [&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
            if (evidence.alphaOf(id) > 0) voxels.push_back(v);
        },
        false);
    return voxels;
}

/** One random change of a map: evidence, a new instance, a merge, a split or a deactivation. */
inline void changeAtRandom(SemanticVoxelMap& map, std::mt19937& random)
{
    std::uniform_int_distribution<int> kind(0, 99);
    std::uniform_int_distribution<int32_t> place(-12, 12);
    const int what = kind(random);
    if (what < 85) {
        const bool unknown = kind(random) < 30;
        const auto weight = static_cast<float>(1 + kind(random));
        map.addEvidence({place(random), place(random) / 3, place(random) / 3},
                        unknown ? UNKNOWN_INSTANCE : anyInstance(map, random), weight);
    } else if (what < 91) {
        Instance& i = map.createInstance();
        CategoryEvidence opinion;
        opinion.add(map.categories().add("category" + std::to_string(kind(random) % 7)), 0.5);
        i.categories.add(opinion, static_cast<side_t>(kind(random) % 3));
        i.categories.add(opinion.entries().front().category, 0.25);
        i.observations = 1;
        InstanceView view;
        view.frame = static_cast<uint32_t>(kind(random));
        view.area = view.frame + 1;
        view.score = view.probability = 0.5F;
        view.target.x = static_cast<float>(place(random));
        i.views.add(i.categories.sum().entries().front().category, view, map.options().views_kept);
        Decision decision;
        decision.evidence = 0.75;
        decision.answer = "none of them";
        i.decisions.push_back(decision);
    } else if (what < 94 && map.instances().size() >= 2) {
        const instance_id_t a = anyInstance(map, random), b = anyInstance(map, random);
        if (a != b) map.merge(a, b, 7);
    } else if (what < 98 && !map.instances().empty()) {
        const instance_id_t id = anyInstance(map, random);
        auto part = voxelsOf(map, id);
        part.resize(part.size() / 3);
        map.split(id, part, 0.25, 7);
    } else if (!map.instances().empty()) {
        map.deactivate(anyInstance(map, random));
    }
}
}  // namespace voxeland::test
