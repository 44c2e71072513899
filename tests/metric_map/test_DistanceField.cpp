// SPDX-License-Identifier: BSD-3-Clause
#include "support/HandMadeMap.h"
#include "voxeland/metric_map/DistanceField.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
constexpr double EDGE = 0.05;

/** A map of scattered occupied voxels, on both sides of the origin, and their centres. */
struct ScatteredVoxels
{
    SemanticVoxelMap map;
    std::vector<TPoint3D> centers;

    ScatteredVoxels()
    {
        std::mt19937 random(7);
        std::uniform_int_distribution<int> coordinate(-20, 20);
        for (int i = 0; i < 150; ++i) {
            const VoxelCoord v{coordinate(random), coordinate(random), coordinate(random)};
            test::setVoxel(map, v);
            centers.emplace_back((v.x + 0.5) * EDGE, (v.y + 0.5) * EDGE, (v.z + 0.5) * EDGE);
        }
    }
    [[nodiscard]] double distance(const TPoint3D& p, double most) const
    {
        double least = most;
        for (const TPoint3D& c : centers) least = std::min(least, (c - p).norm());
        return least;
    }
};
}  // namespace

TEST(DistanceField, IsExactInCentresOfVoxels)
{
    const ScatteredVoxels voxels;
    for (const double reach : {0.04, 0.3, 1.0}) {
        DistanceField field(voxels.map, reach);
        for (int z = -40; z < 40; z += 3)
            for (int y = -40; y < 40; y += 2)
                for (int x = -40; x < 40; ++x) {
                    const TPoint3D p((x + 0.5) * EDGE, (y + 0.5) * EDGE, (z + 0.5) * EDGE);
                    EXPECT_NEAR(std::sqrt(field.squaredDistance(p)), voxels.distance(p, reach),
                                1e-9)
                        << p;
                }
    }
}

TEST(DistanceField, IsNearlyRightElsewhereAndNeverTooSmall)
{
    const ScatteredVoxels voxels;
    constexpr double REACH = 0.4;
    DistanceField field(voxels.map, REACH);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
    double error = 0;
    constexpr int POINTS = 5000;
    for (int i = 0; i < POINTS; ++i) {
        const TPoint3D p(coordinate(random), coordinate(random), coordinate(random));
        const double right = voxels.distance(p, REACH);
        const double given = std::sqrt(field.squaredDistance(p));
        EXPECT_GE(given, right - 1e-9);
        EXPECT_LE(given, right + EDGE * std::sqrt(3.0)) << "twice half a voxel's diagonal";
        error += given - right;
    }
    EXPECT_LT(error / POINTS, 0.002);
}

TEST(DistanceField, FarPointsAndWhatAreNoNumbersAreFar)
{
    const ScatteredVoxels voxels;
    DistanceField field(voxels.map, 0.3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const TPoint3D& p : {TPoint3D(10, 0, 0), TPoint3D(0, -1e300, 0), TPoint3D(0, 0, 1e8),
                              TPoint3D(nan, 0, 0), TPoint3D(0, 0, nan)})
        EXPECT_DOUBLE_EQ(field.squaredDistance(p), 0.09);
}

TEST(DistanceField, FreeVoxelsAreNotOccupied)
{
    SemanticVoxelMap map;
    test::setVoxel(map, {0, 0, 0}, 0.3);
    EXPECT_DOUBLE_EQ(DistanceField(map, 0.5).squaredDistance({0, 0, 0}), 0.25);
    test::setVoxel(map, {4, 0, 0}, 0.7);
    EXPECT_NEAR(DistanceField(map, 0.5).squaredDistance({0.025, 0.025, 0.025}), 0.04, 1e-12);
}

TEST(DistanceField, ReachIsLimited)
{
    const SemanticVoxelMap map;
    EXPECT_NO_THROW(DistanceField(map, 4.9));
    EXPECT_THROW(DistanceField(map, 5.1), std::invalid_argument);
}
