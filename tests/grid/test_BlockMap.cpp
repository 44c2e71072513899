// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/grid/BlockMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace voxeland;

TEST(BlockMap, MakesABlockOnceAndKeepsItInPlace)
{
    BlockMap<int> blocks;
    int& first = blocks.at({-1, 0, 2});
    first = 42;
    for (int i = 0; i < 5000; ++i) blocks.at({i, 1, 1}) = i;
    EXPECT_EQ(&blocks.at({-1, 0, 2}), &first);
    EXPECT_EQ(*blocks.find({-1, 0, 2}), 42);
    EXPECT_EQ(*blocks.find({4999, 1, 1}), 4999);
    EXPECT_EQ(blocks.find({0, 0, 0}), nullptr);
    EXPECT_EQ(blocks.size(), 5001u);
}

TEST(BlockMap, NumbersBlocksInOrderOfCreation)
{
    BlockMap<int> blocks;
    EXPECT_EQ(blocks.indexAt({5, 0, 0}), 0u);
    EXPECT_EQ(blocks.indexAt({-5, 0, 0}), 1u);
    EXPECT_EQ(blocks.indexAt({5, 0, 0}), 0u);
    EXPECT_EQ(blocks.coordOf(1), (VoxelCoord{-5, 0, 0}));
}

TEST(BlockMap, SortedOrderDependsOnContentOnly)
{
    std::vector<VoxelCoord> coords;
    for (int x = -2; x < 2; ++x)
        for (int y = -2; y < 2; ++y)
            for (int z = -2; z < 2; ++z) coords.push_back({x, y, z});
    const auto sortedCoords = [&](unsigned seed) {
        std::shuffle(coords.begin(), coords.end(), std::mt19937(seed));
        BlockMap<int> blocks;
        for (const auto& c : coords) blocks.at(c);
        std::vector<VoxelCoord> result;
        for (const uint32_t b : blocks.sorted()) result.push_back(blocks.coordOf(b));
        return result;
    };
    const auto once = sortedCoords(1);
    EXPECT_EQ(once, sortedCoords(2));
    EXPECT_TRUE(std::is_sorted(once.begin(), once.end()));
}

TEST(BlockMap, CopiesAreIndependent)
{
    BlockMap<int> blocks;
    blocks.at({1, 2, 3}) = 1;
    BlockMap<int> copy = blocks;
    copy.at({1, 2, 3}) = 2;
    copy.at({9, 9, 9}) = 3;
    EXPECT_EQ(*blocks.find({1, 2, 3}), 1);
    EXPECT_EQ(blocks.size(), 1u);
    copy.clear();
    EXPECT_EQ(copy.find({1, 2, 3}), nullptr);
    EXPECT_EQ(copy.size(), 0u);
}
