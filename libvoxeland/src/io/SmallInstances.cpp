// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/SmallInstances.h"

#include "voxeland/map/MapQueries.h"

namespace voxeland
{
void dismissSmallInstances(SemanticVoxelMap& map, uint32_t minVoxels)
{
    for (const InstanceSummary& s : summarizeInstances(map))
        if (s.voxels < minVoxels) map.dismiss(s.id);
}
}  // namespace voxeland
