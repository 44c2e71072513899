// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <memory>
#include <string>

namespace voxeland::test
{
/** An empty map where a voxel is part of the instances with a quarter of its evidence. */
inline SemanticVoxelMap handMadeMap()
{
    MapOptions options;
    options.membership = 0.25;
    return SemanticVoxelMap(options);
}

/** A new instance of one category, seen in one frame. */
inline instance_id_t addInstance(SemanticVoxelMap& map, const std::string& category,
                                 double beta = 1, uint32_t lastFrame = 0)
{
    const category_id_t number = map.categories().add(category);
    Instance& instance = map.createInstance();
    instance.categories.add(number, beta);
    instance.observations = 1;
    instance.firstFrame = lastFrame;
    map.saw(instance.id, lastFrame);
    return instance.id;
}

/** Adds evidence to the occupied voxels of a box. \param corner least \param size edges [voxels] */
inline void addBox(SemanticVoxelMap& map, instance_id_t id, const VoxelCoord& corner,
                   const VoxelCoord& size, float alpha = 1)
{
    for (int32_t z = 0; z < size.z; ++z)
        for (int32_t y = 0; y < size.y; ++y)
            for (int32_t x = 0; x < size.x; ++x) {
                const VoxelCoord v = corner + VoxelCoord{x, y, z};
                map.addEvidence(v, id, alpha);
                map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), 1000);
            }
}

/** Sum of an instance's evidence in all voxels. */
inline double evidenceOf(const SemanticVoxelMap& map, instance_id_t id)
{
    double sum = 0;
    map.forEachVoxel(
        [&](const VoxelCoord&, log_odds_t, const VoxelEvidence& evidence) {
            sum += static_cast<double>(evidence.alphaOf(id));
        },
        false);
    return sum;
}

/** The paper's association, which lets overlap and categories decide about merging.
 *  \param keys more lines of its section */
inline std::shared_ptr<const CAssociationPolicy> evidentialPolicy(const std::string& keys = "")
{
    return MapperConfig(Ini::fromText("[association]\n"
                                      "class = CEvidentialAssociation\n" +
                                          keys,
                                      "the test"))
        .association;
}

/** Refinement with every threshold set. */
inline RefinementOptions handMadeRefinement()
{
    RefinementOptions options;
    options.every = 10;
    options.merge.iou = 0.8;
    options.merge.use_ios = true;
    options.merge.ios = 0.5;
    options.merge.similarity = 0.5;
    options.split = true;
    options.continuity = true;
    options.dbscan_eps = 2;
    options.dbscan_min_points = 4;
    options.min_part_voxels = 12;
    options.min_part_share = 0.1;
    return options;
}
}  // namespace voxeland::test
