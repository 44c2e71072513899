// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MapBlock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

using namespace voxeland;

TEST(MapBlock, KnowsNothingAtFirst)
{
    MapBlock block;
    for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
        EXPECT_EQ(block.occupancy(cell), UNOBSERVED);
        EXPECT_EQ(block.evidence(cell), nullptr);
    }
    EXPECT_EQ(block.observedCells(), 0);
    EXPECT_EQ(block.heapMemory(), 0u);
}

TEST(MapBlock, CountsObservedCells)
{
    MapBlock block;
    block.setOccupancy(0, 5);
    block.setOccupancy(511, -5);
    block.setOccupancy(100, 0);
    EXPECT_EQ(block.observedCells(), 3);
    EXPECT_EQ(block.occupancy(511), -5);
}

TEST(MapBlock, KeepsEvidenceByCellWhateverTheOrderItComes)
{
    std::vector<int> cells(BLOCK_CELLS);
    std::iota(cells.begin(), cells.end(), 0);
    std::shuffle(cells.begin(), cells.end(), std::mt19937(22));
    cells.resize(300);

    MapBlock block;
    for (const int cell : cells)
        block.evidenceAt(cell).add(static_cast<instance_id_t>(cell), static_cast<float>(cell + 1));
    for (const int cell : cells) block.evidenceAt(cell).add(1000, 1);  // found again, not made anew

    std::sort(cells.begin(), cells.end());
    std::vector<int> visited;
    block.forEachSurface([&](int cell, const VoxelEvidence& evidence) {
        visited.push_back(cell);
        EXPECT_EQ(evidence.alphaOf(static_cast<instance_id_t>(cell)), static_cast<float>(cell + 1));
        EXPECT_EQ(evidence.size(), 2u);
        EXPECT_EQ(block.evidence(cell), &evidence);
    });
    EXPECT_EQ(visited, cells);
    EXPECT_EQ(block.surface().count(), 300);
}
