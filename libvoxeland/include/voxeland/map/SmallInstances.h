// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland
{
/** Deactivates instances that win few occupied voxels, for exports that should show objects only.
 *  \param minVoxels what an instance must win to stay */
void deactivateSmallInstances(SemanticVoxelMap& map, uint32_t minVoxels);
}  // namespace voxeland
