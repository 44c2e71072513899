// SPDX-License-Identifier: BSD-3-Clause
#include "grid/RayTraversal.h"
#include "support/TinyMap.h"
#include "voxeland/level/UpDirection.h"

#include <gtest/gtest.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>
#include <functional>

using namespace voxeland;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;
using mrpt::poses::CPose3D;

namespace
{
/** A room of 4 x 3 m with a floor, two walls as seen from inside, and a table, put somewhere. */
SemanticVoxelMap roomAt(const CPose3D& pose)
{
    MapOptions options;
    options.resolution = 0.05;
    SemanticVoxelMap map(options);
    const auto forEachPoint = [&](double step, const auto& f) {
        for (double x = 0; x < 4; x += step)
            for (double y = 0; y < 3; y += step) f(x, y);
    };
    const auto voxelOf = [&](double x, double y, double z) {
        return map.voxelOf(pose.composePoint({x, y, z}));
    };
    forEachPoint(0.025, [&](double x, double y) {
        for (double z = 0; z < 2; z += 0.025) {
            const VoxelCoord v = voxelOf(x, y, z);
            map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), -1000);
        }
    });
    const auto surface = [&](double x, double y, double z) {
        const VoxelCoord v = voxelOf(x, y, z);
        if (map.evidence(v) == nullptr) test::addVoxel(map, v, {{UNKNOWN_INSTANCE, 1}});
    };
    forEachPoint(0.025, [&](double x, double y) {
        surface(x, y, -0.03);
        if (x < 2) surface(x, 3.02, y * 0.66);
        surface(-0.03, y, x / 2);
        if (x > 1.5 && x < 3 && y > 1 && y < 2) surface(x, y, 0.72);
    });
    return map;
}

/** Angle between the direction found for a room and its real up [rad]. */
double errorAt(const CPose3D& pose)
{
    const TVector3D up = pose.rotateVector(TVector3D(0, 0, 1));
    const TVector3D found = estimateUp(roomAt(pose));
    return std::acos(std::min(1.0, up.x * found.x + up.y * found.y + up.z * found.z));
}
constexpr double DEGREE = M_PI / 180;
}  // namespace

TEST(UpDirection, staysExactlyZInLevelMaps)
{
    for (double yaw = 0; yaw < 6; yaw += 0.7) {
        const TVector3D up = estimateUp(roomAt(CPose3D(1, 2, 3, yaw, 0, 0)));
        EXPECT_EQ(up.x, 0) << yaw;
        EXPECT_EQ(up.y, 0) << yaw;
        EXPECT_EQ(up.z, 1) << yaw;
    }
    EXPECT_EQ(estimateUp(SemanticVoxelMap()).z, 1);
    EXPECT_EQ(estimateUp(test::tinyMap()).z, 1);
}

TEST(UpDirection, aWallAloneTellsNothing)
{
    SemanticVoxelMap map;
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 40; ++y) {
            test::addVoxel(map, {20, y, z}, {{UNKNOWN_INSTANCE, 1}});
            for (int x = 10; x < 20; ++x)
                map.blocks().at(blockOf({x, y, z})).setOccupancy(cellOf({x, y, z}), -1000);
        }
    EXPECT_EQ(estimateUp(map).z, 1);
}

/** Two walls that meet in a corner, seen from where a camera stands: what is free ends in its rays
 *  above and below. */
SemanticVoxelMap twoWalls(double yaw, double tallest)
{
    MapOptions options;
    options.resolution = 0.05;
    SemanticVoxelMap map(options);
    const CPose3D pose(0, 0, 0, yaw, 0, 0);
    const TPoint3D camera = pose.composePoint({2, 2, 1.3});
    std::vector<VoxelCoord> surface;
    for (double along = 0; along < 3; along += 0.02)
        for (double z = 0; z < tallest; z += 0.02)
            for (const auto& p : {TPoint3D(along, 0, z), TPoint3D(0, along, z)}) {
                const TPoint3D hit = pose.composePoint(p);
                traverseRay(camera, hit, 1 / options.resolution, [&](const VoxelCoord& v) {
                    map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), -1000);
                });
                surface.push_back(map.voxelOf(hit));
            }
    for (const VoxelCoord& v : surface)
        if (map.evidence(v) == nullptr) test::addVoxel(map, v, {{UNKNOWN_INSTANCE, 1}});
    return map;
}

TEST(UpDirection, twoWallsWithoutAFloorTellNothing)
{
    for (const double yaw : {0.0, 0.2, 0.5, 0.9, 1.3, 2.0})
        for (const double tallest : {0.6, 1.2, 2.5}) {
            const TVector3D up = estimateUp(twoWalls(yaw, tallest));
            EXPECT_EQ(up.z, 1) << yaw << " " << tallest << ": " << up.asString();
        }
}

TEST(UpDirection, levelsATiltedWorld)
{
    EXPECT_LT(errorAt(CPose3D(0, 0, 0, 0.3, 25 * DEGREE, 0)), 2 * DEGREE);
    EXPECT_LT(errorAt(CPose3D(0, 0, 0, 2, -10 * DEGREE, 15 * DEGREE)), 2 * DEGREE);
}

/** Optical axes (x right, y down, z forward) of a camera that looks 20 degrees down, at the walls.
 */
TEST(UpDirection, recognizesOpticalAxes)
{
    const CPose3D opticalFromLevel = -CPose3D(0, 0, 0, -90 * DEGREE, 0, -90 * DEGREE);
    ASSERT_NEAR(opticalFromLevel.rotateVector(TVector3D(0, 0, 1)).y, -1, 1e-9);
    ASSERT_NEAR(opticalFromLevel.rotateVector(TVector3D(1, 0, 0)).z, 1, 1e-9);
    const CPose3D tilt(0, 0, 0, 0, -20 * DEGREE, 0), turned(0, 0, 0, 180 * DEGREE, 0, 0);
    EXPECT_LT(errorAt(opticalFromLevel + tilt + turned), 2 * DEGREE);
}
