// SPDX-License-Identifier: BSD-3-Clause
#include "metric_map/PointsSlice.h"
#include "support/HandMadeMap.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include <thread>

using namespace voxeland;

namespace
{
/** Voxels of 5 cm in a row on the floor, and one 1 m higher. */
SharedVoxelMap rowAndOneAbove()
{
    SharedVoxelMap map;
    SemanticVoxelMap& voxels = map.edit();
    for (int x = 0; x < 10; ++x) test::setVoxel(voxels, {x, 0, 0});
    test::setVoxel(voxels, {3, 0, 20});
    return map;
}

size_t sizeBetween(const SharedVoxelMap& map, float lowest, float highest)
{
    size_t size = 0;
    map.withSlice(lowest, highest, [&](const PointsSlice& slice) { size = slice.points().size(); });
    return size;
}
}  // namespace

TEST(SharedVoxelMap, SlicesHoldTheVoxelsOfTheirHeights)
{
    const SharedVoxelMap map = rowAndOneAbove();
    EXPECT_EQ(sizeBetween(map, 0, 0.5F), 10u);
    EXPECT_EQ(sizeBetween(map, 0.5F, 1.5F), 1u);
    EXPECT_EQ(sizeBetween(map, 0, 1.5F), 11u);
    EXPECT_EQ(sizeBetween(map, 0.03F, 1.02F), 0u) << "heights of centres count: 0.025 and 1.025 m";
    const auto& all = map.points();
    map.withSlice(0.5F, 1.5F, [&](const PointsSlice& slice) {
        float x = 0, y = 0, z = 0;
        all.getPointFast(slice.indexInAll(0), x, y, z);
        EXPECT_FLOAT_EQ(x, 0.175F);
        EXPECT_FLOAT_EQ(z, 1.025F);
    });
}

TEST(SharedVoxelMap, TheLastSliceIsKeptUntilTheMapChanges)
{
    SharedVoxelMap map = rowAndOneAbove();
    const PointsSlice *first = nullptr, *second = nullptr;
    map.withSlice(0, 0.5F, [&](const PointsSlice& slice) { first = &slice; });
    const SharedVoxelMap copy = map;
    copy.withSlice(0, 0.5F, [&](const PointsSlice& slice) { second = &slice; });
    EXPECT_EQ(first, second);
    test::setVoxel(map.edit(), {50, 0, 0});
    EXPECT_EQ(sizeBetween(map, 0, 0.5F), 11u);
    EXPECT_EQ(sizeBetween(copy, 0, 0.5F), 10u) << "the copy is another map";
    test::setVoxel(map.edit(), {60, 0, 0});
    EXPECT_EQ(sizeBetween(map, 0, 0.5F), 12u) << "also where no copy shares it";
}

/** For the preset that looks for data races. */
TEST(SharedVoxelMap, CopiesMayBeAskedAtTheSameTime)
{
    CVoxelandMap map;
    for (int x = 0; x < 200; ++x) test::setVoxel(map.editMap(), {x, 0, x % 3});
    const CVoxelandMap copy = map;
    const auto ask = [](const CVoxelandMap& asked) {
        EXPECT_NEAR(asked.boundingBox().max.x, 10, 1e-5);
        const mrpt::maps::CSimplePointsMap points = *asked.getAsSimplePointsMap();
        mrpt::tfest::TMatchingPairList pairs;
        mrpt::maps::TMatchingExtraResults results;
        asked.determineMatching3D(&points, {}, pairs, {}, results);
        asked.determineMatching2D(&points, {}, pairs, {}, results);
    };
    std::thread other([&] { ask(copy); });
    ask(map);
    other.join();
}
