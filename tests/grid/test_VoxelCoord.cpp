// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/grid/VoxelCoord.h"

#include <gtest/gtest.h>
#include <mrpt/math/TPoint3D.h>

#include <random>
#include <set>

using namespace voxeland;
using mrpt::math::TPoint3D;

TEST(VoxelCoord, CoversHalfOpenIntervalsAlsoBelowZero)
{
    EXPECT_EQ(voxelIndex(0.0, 20), 0);
    EXPECT_EQ(voxelIndex(0.049, 20), 0);
    EXPECT_EQ(voxelIndex(0.05, 20), 1);
    EXPECT_EQ(voxelIndex(-0.001, 20), -1);
    EXPECT_EQ(voxelIndex(-0.05, 20), -1);
    EXPECT_EQ(voxelIndex(-0.051, 20), -2);
    const VoxelCoord v = voxelOf(TPoint3D(-1.01, 0.26, -0.01), 4.0);
    EXPECT_EQ(v, (VoxelCoord{-5, 1, -1}));
}

TEST(VoxelCoord, CenterLiesInItsVoxel)
{
    const auto c = voxelCenter<TPoint3D>({-3, 0, 7}, 0.1);
    EXPECT_NEAR(c.x, -0.25, 1e-12);
    EXPECT_NEAR(c.y, 0.05, 1e-12);
    EXPECT_NEAR(c.z, 0.75, 1e-12);
    EXPECT_EQ(voxelOf(c, 10.0), (VoxelCoord{-3, 0, 7}));
}

TEST(VoxelCoord, OrderIsByZThenYThenX)
{
    EXPECT_LT((VoxelCoord{9, 9, 0}), (VoxelCoord{0, 0, 1}));
    EXPECT_LT((VoxelCoord{9, 0, 1}), (VoxelCoord{0, 1, 1}));
    EXPECT_LT((VoxelCoord{-1, 1, 1}), (VoxelCoord{0, 1, 1}));
    EXPECT_FALSE((VoxelCoord{1, 2, 3}) < (VoxelCoord{1, 2, 3}));
}

TEST(VoxelCoord, PackingIsInjectiveUpToTheLimits)
{
    const std::vector<int32_t> values = {-MAX_VOXEL_COORD,    -MAX_VOXEL_COORD + 1, -8, -1, 0, 1, 7,
                                         MAX_VOXEL_COORD - 1, MAX_VOXEL_COORD};
    std::set<uint64_t> keys;
    for (const int32_t x : values)
        for (const int32_t y : values)
            for (const int32_t z : values) keys.insert(packed({x, y, z}));
    EXPECT_EQ(keys.size(), values.size() * values.size() * values.size());
}

TEST(VoxelCoord, UnpackingGivesTheCoordinatesBack)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<int32_t> any(-MAX_VOXEL_COORD, MAX_VOXEL_COORD);
    for (int i = 0; i < 10000; ++i) {
        const VoxelCoord v = {any(random), any(random), any(random)};
        ASSERT_EQ(unpacked(packed(v)), v);
    }
    for (const int32_t v : {-MAX_VOXEL_COORD - 1, -MAX_VOXEL_COORD, -1, 0, MAX_VOXEL_COORD})
        EXPECT_EQ(unpacked(packed({v, 0, -1})), (VoxelCoord{v, 0, -1}));
}

namespace
{
/** Compares with one bit after the other. */
template <int BITS>
void expectLowBits(const VoxelCoord& v)
{
    size_t expected = 0;
    for (int b = 0; b < BITS; ++b) {
        expected |= static_cast<size_t>((v.x >> b) & 1) << b;
        expected |= static_cast<size_t>((v.y >> b) & 1) << (BITS + b);
        expected |= static_cast<size_t>((v.z >> b) & 1) << (2 * BITS + b);
    }
    ASSERT_EQ(lowBits<BITS>(packed(v)), expected);
}
}  // namespace

TEST(VoxelCoord, LowBitsAreThoseOfEachAxis)
{
    EXPECT_EQ(lowBits<4>(packed({0x7f1, -1, 0x122})), 0x2f1u);
    std::mt19937 random(4);
    std::uniform_int_distribution<int32_t> any(-MAX_VOXEL_COORD, MAX_VOXEL_COORD);
    for (int i = 0; i < 10000; ++i) {
        const VoxelCoord v = {any(random), any(random), any(random)};
        expectLowBits<1>(v);
        expectLowBits<3>(v);
        expectLowBits<4>(v);
        expectLowBits<7>(v);
        ASSERT_EQ(lowBits<3>(packed(v)), static_cast<size_t>(cellOf(v)));
    }
}

TEST(VoxelCoord, BlockAndCellAreTheFloorAndTheRemainder)
{
    EXPECT_EQ(blockOf({-1, -8, -9}), (VoxelCoord{-1, -1, -2}));
    EXPECT_EQ(blockOf({7, 8, 0}), (VoxelCoord{0, 1, 0}));
    EXPECT_EQ(cellOf({-1, -8, -9}), 7 + 0 * 8 + 7 * 64);
    EXPECT_EQ(cellOf({1, 2, 3}), 1 + 2 * 8 + 3 * 64);
}

TEST(VoxelCoord, BlockAndCellGiveTheVoxelBack)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<int32_t> any(-MAX_VOXEL_COORD, MAX_VOXEL_COORD);
    for (int i = 0; i < 10000; ++i) {
        const VoxelCoord v = {any(random), any(random), any(random)};
        ASSERT_GE(cellOf(v), 0);
        ASSERT_LT(cellOf(v), BLOCK_CELLS);
        ASSERT_EQ(voxelAt(blockOf(v), cellOf(v)), v);
    }
    for (int cell = 0; cell < BLOCK_CELLS; ++cell) {
        const VoxelCoord v = voxelAt({-2, 0, 5}, cell);
        EXPECT_EQ(cellOf(v), cell);
        EXPECT_EQ(blockOf(v), (VoxelCoord{-2, 0, 5}));
    }
}
