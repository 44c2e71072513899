// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland::test
{
/** A map of so many rooms, seen one after another: copies of one, side by side along y, `pitch`
 * blocks apart, each seen in the `frames` after those of the one before. Instances of the first
 * copy keep their ids. */
SemanticVoxelMap manyRooms(const SemanticVoxelMap& room, int copies, int pitch, uint32_t frames);
}  // namespace voxeland::test
