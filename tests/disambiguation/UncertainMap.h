// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland::test
{
/** Adds an instance of some voxels with evidence for chair, couch and bed and a view for each of
 * those, in frames 10 id, 10 id + 1, 10 id + 2. */
inline instance_id_t addInstance(SemanticVoxelMap& map, double chair, double couch, double bed,
                                 int32_t voxels = 30)
{
    Instance& instance = map.createInstance();
    const char* const names[] = {"chair", "couch", "bed"};
    const double betas[] = {chair, couch, bed};
    for (uint32_t c = 0; c < 3; ++c) {
        const category_id_t category = map.categories().add(names[c]);
        if (!(betas[c] > 0)) continue;
        instance.categories.add(category, betas[c]);
        InstanceView view;
        view.frame = 10 * instance.id + c;
        view.area = 100;
        view.score = view.probability = 1;
        instance.views.add(category, view, map.options().views_kept);
    }
    for (int32_t x = 0; x < voxels; ++x) {
        const VoxelCoord v = {x, static_cast<int32_t>(instance.id) * 5, 0};
        map.addEvidence(v, instance.id, 1);
        map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), 1000);
    }
    return instance.id;
}
}  // namespace voxeland::test
