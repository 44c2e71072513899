// SPDX-License-Identifier: BSD-3-Clause
#include "grid/RayTraversal.h"
#include "support/Frames.h"
#include "voxeland/observations/ObservedSpace.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
constexpr double RESOLUTION = 0.1;

enum class Seen
{
    hit,
    passed,
    behind
};

std::set<VoxelCoord> voxelsOf(const ObservedSpace& space, Seen what)
{
    std::set<VoxelCoord> voxels;
    for (size_t b = 0; b < space.size(); ++b) {
        const ObservedBlock& block = space[b];
        const CellMask& mask = what == Seen::hit      ? block.hit
                               : what == Seen::passed ? block.passed
                                                      : block.behind;
        mask.forEach([&](int cell) { voxels.insert(voxelAt(space.coordOf(b), cell)); });
    }
    return voxels;
}

VoxelizedFrame frameOf(const test::DepthOfPixel& depth, const mrpt::poses::CPose3D& pose = {},
                       double resolution = RESOLUTION)
{
    return VoxelizedFrame({test::makeScan(depth), nullptr, pose}, resolution, {});
}

/** Voxels that points sampled finely along a segment fall in. */
void sample(const TPoint3D& from, const TPoint3D& to, std::set<VoxelCoord>& voxels)
{
    constexpr int SAMPLES = 4000;
    for (int i = 0; i <= SAMPLES; ++i)
        voxels.insert(
            voxelOf(from + (to - from) * (static_cast<double>(i) / SAMPLES), 1 / RESOLUTION));
}
}  // namespace

TEST(ObservedSpace, HitsAreTheVoxelsOfTheFrame)
{
    const auto frame = frameOf([](int c, int r) { return 1.52 + 0.01 * c - 0.007 * r; });
    std::set<VoxelCoord> expected;
    for (const HitVoxel& h : frame.hits()) expected.insert(h.coord);
    EXPECT_EQ(voxelsOf(castRays(frame, 0), Seen::hit), expected);
}

TEST(ObservedSpace, OnePixelSeesOneRay)
{
    // The ray of pixel (39, 29) leaves the axis by 0.5 / 40 = 1/80 to the left and up.
    const auto frame = frameOf([](int c, int r) { return c == 39 && r == 29 ? 1.05 : 0.0; },
                               mrpt::poses::CPose3D(-0.55, -0.05, -0.05, 0, 0, 0));
    const auto space = castRays(frame, 0.25);
    std::set<VoxelCoord> passed, behind;
    for (int x = -6; x < 5; ++x) passed.insert({x, -1, -1});  // 5 mm per 40 cm: stays in the row
    for (int x = 5; x <= 7; ++x) behind.insert({x, -1, -1});
    EXPECT_EQ(voxelsOf(space, Seen::hit), (std::set<VoxelCoord>{{5, -1, -1}}));
    EXPECT_EQ(voxelsOf(space, Seen::passed), passed);
    EXPECT_EQ(voxelsOf(space, Seen::behind), behind);
}

TEST(ObservedSpace, AgreesWithBruteForce)
{
    const double margin = 0.25;
    const auto frame =
        frameOf([](int c, int r) { return 1.1 + (c > 30 && c < 50 ? 0.0 : 0.7) + 0.004 * r; },
                mrpt::poses::CPose3D(-1.03, 2.04, -0.55, 2.1, 0.3, -0.2));
    std::set<VoxelCoord> hits, passed, behind;
    for (const HitVoxel& h : frame.hits()) {
        hits.insert(h.coord);
        sample(frame.origin(), h.centroid, passed);
        const TPoint3D direction = (h.centroid - frame.origin()).unitarize();
        sample(h.centroid, h.centroid + direction * margin, behind);
    }
    for (const VoxelCoord& v : hits) passed.erase(v);
    const auto space = castRays(frame, margin);
    const auto foundPassed = voxelsOf(space, Seen::passed),
               foundBehind = voxelsOf(space, Seen::behind);
    // A sample may step over the corner of a voxel, never the other way round.
    for (const auto& v : passed) ASSERT_EQ(foundPassed.count(v), 1u);
    for (const auto& v : behind) ASSERT_EQ(foundBehind.count(v), 1u);
    EXPECT_LE(100 * foundPassed.size(), 101 * passed.size());
    EXPECT_LE(100 * foundBehind.size(), 102 * behind.size());
}

TEST(ObservedSpace, BlocksFarApartDoNotMix)
{
    // At 2 cm the view is 25 blocks deep, and rays of some 20 to 400 voxels are cast together.
    const double resolution = 0.02, margin = 0.1;
    const auto frame =
        frameOf([](int c, int r) { return 0.35 + 0.045 * ((7 * c + 3 * r) % 80); },
                mrpt::poses::CPose3D(0.402, -0.003, 0.001, -0.7, 0.4, 0.1), resolution);
    std::set<VoxelCoord> hits, passed, behind;
    for (const HitVoxel& h : frame.hits()) {
        hits.insert(h.coord);
        traverseRay(frame.origin(), h.centroid, 1 / resolution,
                    [&](const VoxelCoord& v) { passed.insert(v); });
        const TPoint3D direction = (h.centroid - frame.origin()).unitarize();
        traverseRay(h.centroid, h.centroid + direction * margin, 1 / resolution,
                    [&](const VoxelCoord& v) { behind.insert(v); });
    }
    for (const VoxelCoord& v : hits) passed.erase(v);
    const auto space = castRays(frame, margin);
    EXPECT_EQ(voxelsOf(space, Seen::hit), hits);
    EXPECT_EQ(voxelsOf(space, Seen::passed), passed);
    EXPECT_EQ(voxelsOf(space, Seen::behind), behind);
}

TEST(ObservedSpace, WhatIsBeyondTheLimitClearsTheSpaceUpToIt)
{
    // The ray of pixel (39, 29) leaves the axis by 1/80 to the left and up: at the limit, 4 m from
    // the camera, it is in row 0 still.
    const auto space = castRays(frameOf([](int c, int r) { return c == 39 && r == 29 ? 6.0 : 0.0; },
                                        mrpt::poses::CPose3D(-0.55, 0.02, 0.02, 0, 0, 0)),
                                0.25);
    std::set<VoxelCoord> passed;  // up to x = 3.45, whose voxel is not cleared as a whole
    for (int x = -6; x < 34; ++x) passed.insert({x, 0, 0});
    EXPECT_EQ(voxelsOf(space, Seen::passed), passed);
    EXPECT_TRUE(voxelsOf(space, Seen::hit).empty());
    EXPECT_TRUE(voxelsOf(space, Seen::behind).empty());
}

TEST(ObservedSpace, SurfacesWithinTheLimitAndBeyondItAreSeenTogether)
{
    // A post at 2 m before a wall at 9 m; every ray by itself, by another traversal.
    const auto depth = [](int c, int) { return c > 30 && c < 50 ? 2.0 : 9.0; };
    const mrpt::poses::CPose3D pose(-1.03, 2.04, -0.55, 2.1, 0.3, -0.2);
    const auto frame = frameOf(depth, pose);
    std::set<VoxelCoord> hits, passed;
    for (const HitVoxel& h : frame.hits()) {
        hits.insert(h.coord);
        traverseRay(frame.origin(), h.centroid, 1 / RESOLUTION,
                    [&](const VoxelCoord& v) { passed.insert(v); });
    }
    uint32_t pixels = 0;
    for (const HitVoxel& h : frame.beyond()) {
        pixels += h.points;
        EXPECT_NEAR(pose.inverseComposePoint(h.centroid).x, 4, 1e-4) << "not at the limit";
        std::vector<VoxelCoord> way;
        traverseRay(frame.origin(), h.centroid, 1 / RESOLUTION,
                    [&](const VoxelCoord& v) { way.push_back(v); });
        EXPECT_EQ(way.back(), h.coord);
        passed.insert(way.begin(), way.end() - 1);
    }
    EXPECT_EQ(pixels, static_cast<uint32_t>((test::COLUMNS - 19) * test::ROWS));
    for (const VoxelCoord& v : hits) passed.erase(v);
    const auto space = castRays(frame, 0);
    EXPECT_EQ(voxelsOf(space, Seen::hit), hits);
    EXPECT_EQ(voxelsOf(space, Seen::passed), passed);
}

TEST(ObservedSpace, UnknownPixelsClearNothing)
{
    const auto scan = test::makeScan([](int, int) { return 0.0; });
    for (int c = 0; c < test::COLUMNS / 2; ++c)
        for (int r = 0; r < test::ROWS; ++r) scan->rangeImage(r, c) = 65535;
    const VoxelizedFrame frame({scan, nullptr, {}}, RESOLUTION, {});
    EXPECT_EQ(castRays(frame, 0.1).size(), 0u);
    EXPECT_EQ(frame.depths().pixels, 0u);
}

TEST(ObservedSpace, AMeasuredVoxelIsNeverFree)
{
    // A slanted surface: rays to its far end pass through voxels hit nearer by.
    const auto space = castRays(
        frameOf([](int, int r) { return 1.2 / (0.1 + std::max(0, r - 29) / 40.0 * 0.8); }), 0.1);
    for (size_t b = 0; b < space.size(); ++b) {
        EXPECT_FALSE((space[b].hit & space[b].passed).any());
        EXPECT_EQ(space[b].visible(), space[b].hit | space[b].passed | space[b].behind);
    }
}

TEST(ObservedSpace, AFrameWithoutPointsSeesNothing)
{
    EXPECT_EQ(castRays(frameOf([](int, int) { return 0.0; }), 0.1).size(), 0u);
}

TEST(ObservedSpace, WhatNeitherMemoryNorAMapCanHoldIsRefused)
{
    const auto errorOf = [](double metres, double resolution, const mrpt::poses::CPose3D& pose) {
        auto scan = test::makeScan([](int, int) { return 1.0; });
        scan->rangeUnits = static_cast<float>(metres / 1000);  // it holds 1000 of them
        try {
            castRays(VoxelizedFrame({scan, nullptr, pose}, resolution, {0.1, 20000}), 0);
        } catch (const UnusableFrame& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(errorOf(16, 0.05, {}), "no error");
    EXPECT_NE(errorOf(400, 0.001, {}).find("fit into memory"), std::string::npos)
        << "4800 rays of at least 400,000 cells";
    EXPECT_NE(errorOf(100, 0.01, {}).find("fit into memory"), std::string::npos)
        << "at most 144 million cells, but in more than a million blocks";
    EXPECT_NE(errorOf(16000, 0.01, {}).find("farther off"), std::string::npos);
    EXPECT_NE(errorOf(10, 0.01, mrpt::poses::CPose3D(10480, 0, 0, 0, 0, 0)).find("farther off"),
              std::string::npos)
        << "2^20 cells from the origin";
}
