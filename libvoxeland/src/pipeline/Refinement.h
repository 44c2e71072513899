// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/MappingCounts.h"
#include "voxeland/pipeline/MapperConfig.h"

namespace voxeland
{
class MappingTrace;

/** Mends over- and under-segmentation (paper, "Intra-instance Geometric Division" and
 * "Multi-instance Integration"): divides instances whose voxels fell apart, then merges instances
 * that are one object. Cost: the voxels of the instances seen since `sinceFrame`, whatever the size
 * of the map.
 *  \param sinceFrame frames that had been mapped at the last refinement
 *  \param isFirst since the map was read, edited or got other options: it is judged of all
 * instances, and not only of those seen lately, whether too little speaks for them \param counts
 * splits and merges are counted there \param trace is told all decisions, if there is one */
void refine(SemanticVoxelMap& map, const CAssociationPolicy& policy,
            const RefinementOptions& options, uint32_t sinceFrame, bool isFirst,
            MappingCounts& counts, MappingTrace* trace = nullptr);
}  // namespace voxeland
