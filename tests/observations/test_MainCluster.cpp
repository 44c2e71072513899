// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/observations/Opinion.h"
#include "voxeland/observations/VoxelizedFrame.h"

#include <gtest/gtest.h>

#include <set>

using namespace voxeland;

namespace
{
constexpr double RESOLUTION = 0.05;

VoxelizedFrame frameOf(const test::DepthOfPixel& depth)
{
    return VoxelizedFrame({test::makeScan(depth), nullptr, {}}, RESOLUTION, {});
}

double pointsOf(const std::vector<OpinionVoxel>& voxels)
{
    double points = 0;
    for (const auto& v : voxels) points += static_cast<double>(v.points);
    return points;
}

/** Greatest distance of the voxels from the plane of the image [m]. */
double farthest(const VoxelizedFrame& frame, const std::vector<OpinionVoxel>& voxels)
{
    double x = 0;
    for (const auto& v : voxels) x = std::max(x, frame.hits()[v.hit].centroid.x);
    return x;
}
}  // namespace

TEST(MainCluster, BackgroundThatBleedsIntoTheMaskIsRemoved)
{
    // A box of 20x20 pixels at 1 m before a wall at 3 m; the mask is three pixels too wide.
    const auto frame =
        frameOf([](int c, int r) { return c >= 30 && c < 50 && r >= 20 && r < 40 ? 1.02 : 3.02; });
    const auto mask = test::rectangleMask(27, 17, 53, 43);
    const auto kept = mainCluster(frame, mask, {});
    EXPECT_EQ(pointsOf(kept), 400);
    EXPECT_LT(farthest(frame, kept), 1.1);

    ClusteringOptions all;
    all.enabled = false;
    EXPECT_EQ(pointsOf(mainCluster(frame, mask, all)), 26 * 26);
}

TEST(MainCluster, ASmallFarObjectIsKept)
{
    // 6x6 pixels at 3.5 m: half a metre wide at this coarse image.
    const auto frame =
        frameOf([](int c, int r) { return c >= 40 && c < 46 && r >= 30 && r < 36 ? 3.52 : 0.0; });
    EXPECT_EQ(pointsOf(mainCluster(frame, test::rectangleMask(40, 30, 46, 36), {})), 36);
}

TEST(MainCluster, AThinObjectIsKept)
{
    // A pole two pixels (5 cm) wide at 1 m over the whole height of the image.
    const auto frame = frameOf([](int c, int) { return c == 40 || c == 41 ? 1.02 : 3.5; });
    const auto kept = mainCluster(frame, test::rectangleMask(40, 0, 42, 60), {});
    EXPECT_EQ(pointsOf(kept), 120);
}

TEST(MainCluster, CoarseCellsAreOfOneSizeOnBothSidesOfTheOrigin)
{
    // A box and a wall 0.2 m behind it: between their coarse cells of 0.1 m lies one empty cell,
    // so that they are apart wherever the camera stands on the grid of coarse cells.
    for (const double x : {0.0, -0.6, -1.0, -1.05, -1.1, -1.15, -1.2, -1.3, -3.0}) {
        RgbdFrame frame;
        frame.scan = test::makeScan(
            [](int c, int r) { return c >= 30 && c < 50 && r >= 20 && r < 40 ? 1.02 : 1.22; });
        frame.robotPose = mrpt::poses::CPose3D(x, 0, 0, 0, 0, 0);
        const VoxelizedFrame voxels(frame, RESOLUTION, {});
        EXPECT_EQ(pointsOf(mainCluster(voxels, test::rectangleMask(27, 17, 53, 43), {})), 400) << x;
    }
}

TEST(MainCluster, EachVoxelOnceWithItsNumberOfPoints)
{
    const auto frame = frameOf([](int c, int r) { return 1 + 0.004 * c + 0.003 * r; });
    const auto mask = test::rectangleMask(10, 10, 70, 50);
    std::set<uint32_t> hits;
    for (const auto& v : mainCluster(frame, mask, {})) {
        EXPECT_TRUE(hits.insert(v.hit).second);
        EXPECT_GT(v.points, 0);
        EXPECT_LE(v.points, static_cast<float>(frame.hits()[v.hit].points));
    }
    EXPECT_FALSE(hits.empty());
}

TEST(MainCluster, MasksWithFewPointsMakeNoOpinion)
{
    const auto frame = frameOf([](int, int) { return 1.02; });
    ClusteringOptions options;
    options.min_points = 20;
    EXPECT_TRUE(mainCluster(frame, test::rectangleMask(0, 0, 19, 1), options).empty());
    EXPECT_EQ(pointsOf(mainCluster(frame, test::rectangleMask(0, 0, 20, 1), options)), 20);
    EXPECT_TRUE(mainCluster(frame, test::rectangleMask(0, 0, 0, 0), options).empty());
}

TEST(RegionOf, TheBoxTheAreaAndWhetherTheBorderIsReached)
{
    const ImageRegion inside = regionOf(test::rectangleMask(10, 20, 15, 40));
    EXPECT_EQ(inside.box, (PixelBox{10, 20, 5, 20}));
    EXPECT_EQ(inside.area, 100U);
    EXPECT_FALSE(inside.truncated);
    constexpr int C = test::COLUMNS, R = test::ROWS;
    EXPECT_TRUE(regionOf(test::rectangleMask(0, 20, 15, 40)).truncated);
    EXPECT_TRUE(regionOf(test::rectangleMask(10, 0, 15, 40)).truncated);
    EXPECT_TRUE(regionOf(test::rectangleMask(10, 20, C, 40)).truncated);
    EXPECT_TRUE(regionOf(test::rectangleMask(10, 20, 15, R)).truncated);
    EXPECT_FALSE(regionOf(test::rectangleMask(1, 1, C - 1, R - 1)).truncated);
}
