// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/SemanticVoxelMap.h"

#include <gtest/gtest.h>

#include <malloc.h>

using namespace voxeland;

namespace
{
/** A room of 5 x 4 x 2.5 m, not aligned with the blocks: walls of one voxel seen as `instances`
 *  objects, free space within. */
void furnish(SemanticVoxelMap& map, uint32_t instances)
{
    for (uint32_t i = 0; i < instances; ++i) map.createInstance();
    const VoxelCoord least = {-53, -41, -3}, most = {47, 39, 47};
    for (int z = least.z; z <= most.z; ++z)
        for (int y = least.y; y <= most.y; ++y)
            for (int x = least.x; x <= most.x; ++x) {
                const VoxelCoord v = {x, y, z};
                const bool wall = x == least.x || x == most.x || y == least.y || y == most.y ||
                                  z == least.z || z == most.z;
                map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), wall ? 1000 : -1000);
                if (!wall) continue;
                map.addEvidence(v, UNKNOWN_INSTANCE, 1);
                for (instance_id_t id = 1; id <= instances; ++id) map.addEvidence(v, id, 1);
            }
}
}  // namespace

TEST(MapMemory, FreeAndSurfaceVoxelsAreWithinBudget)
{
    SemanticVoxelMap map;
    furnish(map, 3);
    const auto memory = map.memory();
    EXPECT_EQ(memory.observedVoxels, 101u * 81u * 51u);
    EXPECT_EQ(memory.surfaceVoxels, 101u * 81u * 51u - 99u * 79u * 49u);
    EXPECT_LE(memory.bytesPerFreeVoxel(), 8);
    EXPECT_LE(memory.bytesPerSurfaceVoxel(), 64);
    EXPECT_GT(memory.bytesPerFreeVoxel(), sizeof(log_odds_t));
    EXPECT_GT(memory.bytesPerSurfaceVoxel(), sizeof(VoxelEvidence));
}

TEST(MapMemory, WhatIsReportedIsWhatTheAllocatorGave)
{
    const auto inUse = [] {
        const auto info = mallinfo2();
        return static_cast<double>(info.uordblks + info.hblkhd);
    };
    const double before = inUse();
    SemanticVoxelMap map;
    furnish(map, 3);
    const double after = inUse();
    if (after == before) GTEST_SKIP() << "a sanitizer's allocator does not tell";
    // Sets of blocks per instance are not voxels' memory; they are small.
    EXPECT_NEAR(static_cast<double>(map.memory().bytes), after - before, 0.15 * (after - before));
}

TEST(MapMemory, OfAnEmptyMapIsZero)
{
    const auto memory = SemanticVoxelMap().memory();
    EXPECT_EQ(memory.bytesPerFreeVoxel(), 0);
    EXPECT_EQ(memory.bytesPerSurfaceVoxel(), 0);
}
