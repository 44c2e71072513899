// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

namespace voxeland::test
{
/** A map of so many rooms: copies of one, side by side along y, `pitch` blocks apart. Instances of
 * the first copy keep their ids. */
SemanticVoxelMap manyRooms(const SemanticVoxelMap& room, int copies, int pitch);
}  // namespace voxeland::test
