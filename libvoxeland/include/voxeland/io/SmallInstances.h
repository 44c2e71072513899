// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland
{
/** Gives what speaks for instances that win few occupied voxels to *unknown* and forgets them:
 *  stray detections, for exports that should show objects only.
 *  \param minVoxels what an instance must win to stay */
void dropSmallInstances(SemanticVoxelMap& map, uint32_t minVoxels);
}  // namespace voxeland
