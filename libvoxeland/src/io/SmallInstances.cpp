// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/SmallInstances.h"

#include "voxeland/map/MapQueries.h"

namespace voxeland
{
void dropSmallInstances(SemanticVoxelMap& map, uint32_t minVoxels)
{
    std::map<instance_id_t, uint32_t> won;
    for (const auto& [id, instance] : map.instances()) won[id] = 0;
    for (const InstanceSummary& s : summarizeInstances(map)) won[s.id] = s.voxels;
    for (const auto& [id, voxels] : won)
        if (voxels < minVoxels) map.drop(id);
}
}  // namespace voxeland
