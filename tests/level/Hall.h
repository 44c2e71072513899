// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "support/TinyMap.h"

namespace voxeland::test
{
/** Free space of 8 x 8 x 8 voxels, in it a pole, a floor below and a lamp above the heights, as
 *  seen by a camera whose axes may be turned: `at` gives the voxel of a level place. */
template <typename At>
SemanticVoxelMap hall(At&& at)
{
    SemanticVoxelMap map = emptyMap();
    const auto set = [&](int x, int y, int z, double p) {
        addVoxel(map, at(x, y, z), {{UNKNOWN_INSTANCE, 1}}, p);
    };
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) set(x, y, z, z == 0 ? 0.9 : 0.2);
    for (int z = 1; z < 5; ++z) set(2, 5, z, 0.95);
    set(4, 4, 12, 0.9);
    set(6, 1, 3, 0.4);
    return map;
}

inline SemanticVoxelMap levelHall()
{
    return hall([](int x, int y, int z) { return VoxelCoord{x, y, z}; });
}
}  // namespace voxeland::test
