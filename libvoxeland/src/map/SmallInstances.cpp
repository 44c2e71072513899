// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/SmallInstances.h"

#include "voxeland/map/MapQueries.h"

#include <set>

namespace voxeland
{
void deactivateSmallInstances(SemanticVoxelMap& map, uint32_t minVoxels)
{
    std::set<instance_id_t> large;
    for (const InstanceSummary& s : summarizeInstances(map))
        if (s.voxels >= minVoxels) large.insert(s.id);
    // Also those that win no voxel: they would, once what outvotes them is gone.
    for (const auto& [id, instance] : map.instances())
        if (large.count(id) == 0) map.deactivate(id);
}
}  // namespace voxeland
