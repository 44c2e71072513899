// SPDX-License-Identifier: BSD-3-Clause
#include "support/TinyMap.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <gtest/gtest.h>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
void expectNear(const TPoint3D& actual, const TPoint3D& expected)
{
    for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(actual[a], expected[a], 1e-12) << a;
}
}  // namespace

TEST(GravityAlignedFrame, isTheMapsWhereUpIsZ)
{
    for (const GravityAlignedFrame& frame : {GravityAlignedFrame(), GravityAlignedFrame({0, 0, 3})})
        expectNear(frame.toLevel({1, 2, 3}), {1, 2, 3});
}

/** A camera's axes: x right, y down, z ahead. Level: x right, y ahead, z up. */
TEST(GravityAlignedFrame, ofOpticalAxes)
{
    const GravityAlignedFrame frame({0, -2, 0});
    expectNear(frame.toLevel({1, 2, 3}), {1, 3, -2});
    expectNear(frame.toMap({1, 3, -2}), {1, 2, 3});
}

TEST(GravityAlignedFrame, whereUpIsX)
{
    const GravityAlignedFrame frame({1, 0, 0});
    EXPECT_NEAR(frame.toLevel({5, 0, 0}).z, 5, 1e-12);
    expectNear(frame.toMap(frame.toLevel({1, 2, 3})), {1, 2, 3});
}

TEST(GravityAlignedFrame, turnsAboutUp)
{
    const GravityAlignedFrame turned = GravityAlignedFrame({0, -1, 0}).turned(M_PI / 2);
    expectNear(turned.axes()[0], {0, 0, 1});
    expectNear(turned.axes()[2], {0, -1, 0});
}

/** 1000 voxels of floor at x = 2, up being -x; a wall; five strays below the floor. */
TEST(FloorHeight, isTheTopOfTheFloor)
{
    SemanticVoxelMap map = test::emptyMap();
    for (int y = 0; y < 50; ++y)
        for (int z = 0; z < 20; ++z) test::addVoxel(map, {20, y, z}, {{UNKNOWN_INSTANCE, 1}});
    for (int x = 0; x < 20; ++x) test::addVoxel(map, {x, 0, 0}, {{UNKNOWN_INSTANCE, 1}});
    for (int y = 0; y < 5; ++y) test::addVoxel(map, {30, y, 0}, {{UNKNOWN_INSTANCE, 1}});
    EXPECT_NEAR(floorHeight(map, GravityAlignedFrame({-1, 0, 0})), -2.0, 1e-9);
    EXPECT_EQ(floorHeight(SemanticVoxelMap(), GravityAlignedFrame()), 0);
}
