// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/grid/CoordHash.h"

#include <gtest/gtest.h>

#include <random>
#include <tuple>
#include <unordered_map>

using namespace voxeland;

TEST(CoordHash, HoldsNothingAtFirst)
{
    const CoordHash hash;
    EXPECT_EQ(hash.size(), 0u);
    EXPECT_EQ(hash.memory(), 0u);
    EXPECT_EQ(hash.find({0, 0, 0}), CoordHash::NONE);
}

TEST(CoordHash, BehavesLikeAStandardHashMap)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<int32_t> near(-12, 12);
    CoordHash hash;
    std::unordered_map<uint64_t, uint32_t> reference;
    for (uint32_t i = 0; i < 30000; ++i) {
        const VoxelCoord c = {near(random), near(random), near(random)};
        ASSERT_EQ(hash.insert(c, i), reference.emplace(packed(c), i).first->second);
        const VoxelCoord asked = {near(random), near(random), near(random)};
        const auto expected = reference.find(packed(asked));
        ASSERT_EQ(hash.find(asked),
                  expected == reference.end() ? CoordHash::NONE : expected->second);
        ASSERT_EQ(hash.size(), reference.size());
    }
}

TEST(CoordHash, KeepsEverythingWhenRoomIsReserved)
{
    CoordHash hash;
    hash.insert({-1, 2, -3}, 7);
    hash.reserve(5000);
    const size_t room = hash.memory();
    for (uint32_t i = 0; i < 4999; ++i) hash.insert({static_cast<int32_t>(i), -1, 0}, i);
    EXPECT_EQ(hash.memory(), room);
    EXPECT_EQ(hash.find({-1, 2, -3}), 7u);
    EXPECT_EQ(hash.find({4998, -1, 0}), 4998u);
}

TEST(CoordHash, IsEmptyAgainAfterClear)
{
    CoordHash hash;
    hash.insert({1, 1, 1}, 0);
    hash.clear();
    EXPECT_EQ(hash.size(), 0u);
    EXPECT_EQ(hash.find({1, 1, 1}), CoordHash::NONE);
    EXPECT_EQ(hash.insert({1, 1, 1}, 5), 5u);
}

TEST(CoordHash, FindsWhatMapsHoldAtFirstSight)
{
    // Blocks of floors and walls, of lines, and of a cube; around the origin and far from it. A
    // table at most half full needs (1 + 1 / (1 - 1/2)) / 2 = 1.5 probes at random (Knuth, vol.
    // 3, 6.4).
    const auto meanProbes = [](int32_t columns, int32_t rows, int32_t layers, int32_t from) {
        CoordHash hash;
        uint32_t n = 0;
        for (int32_t z = 0; z < layers; ++z)
            for (int32_t y = 0; y < rows; ++y)
                for (int32_t x = 0; x < columns; ++x)
                    hash.insert({from + x, from / 2 + y, z - layers / 2}, n++);
        return hash.meanProbes();
    };
    for (const int32_t from : {-40, 0, 17, -100000})
        for (const auto& [x, y, z] :
             {std::tuple(120, 100, 1), std::tuple(90, 1, 30), std::tuple(1, 90, 30),
              std::tuple(20, 20, 20), std::tuple(3000, 1, 1), std::tuple(1, 1, 3000)})
            EXPECT_LT(meanProbes(x, y, z, from), 1.5) << x << "x" << y << "x" << z << " " << from;
}
