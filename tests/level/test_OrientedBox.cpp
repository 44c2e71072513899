// SPDX-License-Identifier: BSD-3-Clause
#include "support/TinyMap.h"
#include "voxeland/level/OrientedBox.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace voxeland;

TEST(OrientedBox, alongTheDiagonal)
{
    std::vector<VoxelCoord> voxels;
    for (int i = -3; i <= 3; ++i) voxels.push_back({i, -i, 2});
    const OrientedBox box = orientedBox(voxels, 0.1);
    EXPECT_NEAR(box.yaw, -M_PI / 4, 1e-9);
    EXPECT_NEAR(box.size.x, 0.6 * std::sqrt(2) + 0.1, 1e-9);
    EXPECT_NEAR(box.size.y, 0.1, 1e-9);
    EXPECT_NEAR(box.size.z, 0.1, 1e-9);
    EXPECT_NEAR(box.center.x, 0.05, 1e-9);
    EXPECT_NEAR(box.center.y, 0.05, 1e-9);
    EXPECT_NEAR(box.center.z, 0.25, 1e-9);
}

TEST(OrientedBox, longerAlongY)
{
    std::vector<VoxelCoord> voxels;
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 2; ++x) voxels.push_back({x, y, 0});
    const OrientedBox box = orientedBox(voxels, 0.5);
    EXPECT_NEAR(std::abs(box.yaw), M_PI / 2, 1e-9);
    EXPECT_NEAR(box.size.x, 3, 1e-9);
    EXPECT_NEAR(box.size.y, 1, 1e-9);
    EXPECT_NEAR(box.center.x, 0.5, 1e-9);
    EXPECT_NEAR(box.center.y, 1.5, 1e-9);
}

TEST(OrientedBox, aShapeWithoutDirectionIsNotTurned)
{
    std::vector<VoxelCoord> voxels;
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 7; ++x) voxels.push_back({x + 1000, y - 333, 0});
    EXPECT_EQ(orientedBox(voxels, 0.05).yaw, 0);
}

/** A rectangle of 2 x 0.6 m turned by a known angle, in voxels: the box comes back, to a voxel. */
TEST(OrientedBox, findsATurnedRectangle)
{
    constexpr double YAW = 0.5, RESOLUTION = 0.02;
    std::vector<VoxelCoord> voxels;
    for (double a = -1; a <= 1; a += RESOLUTION / 2)
        for (double b = -0.3; b <= 0.3; b += RESOLUTION / 2)
            voxels.push_back(
                {static_cast<int>(std::floor((std::cos(YAW) * a - std::sin(YAW) * b) / RESOLUTION)),
                 static_cast<int>(std::floor((std::sin(YAW) * a + std::cos(YAW) * b) / RESOLUTION)),
                 0});
    const OrientedBox box = orientedBox(voxels, RESOLUTION);
    EXPECT_NEAR(box.yaw, YAW, 0.01);
    EXPECT_NEAR(box.size.x, 2, 2 * RESOLUTION);
    EXPECT_NEAR(box.size.y, 0.6, 2 * RESOLUTION);
}

/** The rectangle stands on its side in a camera's axes (y down): its length along z, up is -y. */
TEST(OrientedBox, isUprightWhereverUpIs)
{
    std::vector<VoxelCoord> voxels;
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 3; ++y) voxels.push_back({0, y, z});
    const OrientedBox box = orientedBox(voxels, 0.1, GravityAlignedFrame({0, -1, 0}));
    EXPECT_NEAR(box.size.x, 0.8, 1e-9);
    EXPECT_NEAR(box.size.y, 0.1, 1e-9);
    EXPECT_NEAR(box.size.z, 0.3, 1e-9);
    EXPECT_NEAR(std::abs(box.axes.axes()[0].z), 1, 1e-9);
    EXPECT_NEAR(box.axes.axes()[2].y, -1, 1e-9);
    EXPECT_NEAR(box.center.x, 0.05, 1e-9);
    EXPECT_NEAR(box.center.y, 0.15, 1e-9);
    EXPECT_NEAR(box.center.z, 0.4, 1e-9);
}

namespace
{
/** Least area over all angles, a tenth of a degree apart, of rectangles around voxels [edges^2]. */
double leastAreaByTrying(const std::vector<VoxelCoord>& voxels)
{
    double least = INFINITY;
    for (double angle = 0; angle < M_PI / 2; angle += M_PI / 1800) {
        double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
        for (const VoxelCoord& v : voxels) {
            const double x = std::cos(angle) * v.x + std::sin(angle) * v.y;
            const double y = std::cos(angle) * v.y - std::sin(angle) * v.x;
            x0 = std::min(x0, x);
            x1 = std::max(x1, x);
            y0 = std::min(y0, y);
            y1 = std::max(y1, y);
        }
        least = std::min(least, (x1 - x0 + 1) * (y1 - y0 + 1));
    }
    return least;
}
}  // namespace

TEST(OrientedBox, noTurnedRectangleIsSmaller)
{
    std::mt19937 random(6);
    for (int run = 0; run < 50; ++run) {
        std::uniform_int_distribution<int32_t> step(-1, 1);
        std::vector<VoxelCoord> voxels = {{-7000, 3000, 5}};
        std::set<VoxelCoord> met(voxels.begin(), voxels.end());
        while (voxels.size() < 60) {  // a connected walk
            const VoxelCoord next = voxels.back() + VoxelCoord{step(random), step(random), 0};
            voxels.push_back(next);
            met.insert(next);
        }
        voxels.assign(met.begin(), met.end());
        const OrientedBox box = orientedBox(voxels, 1);
        const double tried = leastAreaByTrying(voxels), area = box.size.x * box.size.y;
        EXPECT_LE(area, tried * 1.0002) << run;
        EXPECT_GE(area, tried * 0.98) << run << ": no rectangle can be that small";
        EXPECT_GE(box.size.x, box.size.y * 0.999);
        EXPECT_GT(box.yaw, -M_PI / 2 - 1e-9);
        EXPECT_LE(box.yaw, M_PI / 2 + 1e-9);
    }
}

TEST(OrientedBox, strayVoxelsDoNotStretchIt)
{
    std::vector<VoxelCoord> voxels;
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 4; ++y) voxels.push_back({x, y, 0});
    const OrientedBox alone = orientedBox(voxels, 0.1);
    for (int x = 0; x < 3; ++x) voxels.push_back({30 + x, 20, 9});  // less than a tenth
    const OrientedBox box = orientedBox(voxels, 0.1);
    EXPECT_EQ(box.size, alone.size);
    EXPECT_EQ(box.center, alone.center);
    voxels.push_back({33, 20, 9});  // a tenth: a part of it
    EXPECT_NEAR(orientedBox(voxels, 0.1).size.z, 1, 1e-9);
}

TEST(OrientedBox, onlyOccupiedVoxelsOfTheWinner)
{
    const auto boxes = orientedBoxes(test::tinyMap(), GravityAlignedFrame());
    ASSERT_EQ(boxes.size(), 2U);
    EXPECT_NEAR(boxes.at(2).center.x, 0.15, 1e-9);
    EXPECT_NEAR(boxes.at(2).size.z, 0.1, 1e-9);
}
