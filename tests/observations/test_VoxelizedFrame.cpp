// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"
#include "voxeland/observations/VoxelizedFrame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace voxeland;
using mrpt::math::TPoint3D;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::poses::CPose3D;
using voxeland::test::makeScan;

namespace
{
constexpr double RESOLUTION = 0.05;

RgbdFrame frameOf(std::shared_ptr<const CObservation3DRangeScan> scan, const CPose3D& pose = {})
{
    return {std::move(scan), nullptr, pose};
}

struct Expected
{
    uint32_t points = 0;
    TPoint3D sum;
};

/** Unprojects pixel by pixel in double precision. Points within rounding of a voxel's boundary may
 *  go either way: their pixels count in `uncertain`. */
struct BruteForce
{
    std::map<VoxelCoord, Expected> voxels;
    std::set<VoxelCoord> uncertain;

    BruteForce(const CObservation3DRangeScan& scan, const CPose3D& sensorPose, double resolution,
               const DepthLimits& limits)
    {
        for (int row = 0; row < test::ROWS; ++row)
            for (int column = 0; column < test::COLUMNS; ++column) {
                const double range =
                    scan.rangeImage(row, column) * static_cast<double>(scan.rangeUnits);
                TPoint3D p(1, -(column - test::CENTER_X) / test::FOCAL,
                           -(row - test::CENTER_Y) / test::FOCAL);
                p *= scan.range_is_depth ? range : range / p.norm();
                if (range == 0 || range < limits.min_depth || range > limits.max_depth) continue;
                p = sensorPose.composePoint(p);
                const VoxelCoord v = voxelOf(p, 1 / resolution);
                ++voxels[v].points;
                voxels[v].sum += p;
                for (size_t a = 0; a < 3; ++a)
                    for (const double shift : {-2e-5, 2e-5}) {
                        TPoint3D moved = p;
                        moved[a] += shift;
                        const VoxelCoord other = voxelOf(moved, 1 / resolution);
                        if (other == v) continue;
                        uncertain.insert(v);
                        uncertain.insert(other);
                    }
            }
    }
};

void expectAsBruteForce(const RgbdFrame& frame, const DepthLimits& limits = {})
{
    const VoxelizedFrame voxels(frame, RESOLUTION, limits);
    const BruteForce expected(*frame.scan, frame.robotPose + frame.scan->sensorPose, RESOLUTION,
                              limits);
    std::set<VoxelCoord> found;
    for (const HitVoxel& h : voxels.hits()) {
        ASSERT_TRUE(found.insert(h.coord).second) << "a voxel twice";
        if (expected.uncertain.count(h.coord) != 0) continue;
        const auto at = expected.voxels.find(h.coord);
        ASSERT_NE(at, expected.voxels.end());
        ASSERT_EQ(h.points, at->second.points);
        ASSERT_LT((h.centroid - at->second.sum * (1.0 / h.points)).norm(), 1e-4);
    }
    for (const auto& [v, e] : expected.voxels)
        ASSERT_TRUE(found.count(v) == 1 || expected.uncertain.count(v) == 1);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(expected.uncertain.size(), found.size() / 5 + 3);
}

double bumpy(int column, int row)
{
    return 1.3 + 0.4 * std::sin(column * 0.11) + 0.011 * row;
}
}  // namespace

TEST(VoxelizedFrame, AWallFillsExactlyItsVoxels)
{
    // At 2.02 m a pixel is 5.05 cm wide: the columns of 1-voxel steps are known by hand.
    const VoxelizedFrame frame(frameOf(makeScan([](int, int) { return 2.02; })), RESOLUTION, {});
    std::map<VoxelCoord, uint32_t> expected;
    for (int row = 0; row < test::ROWS; ++row)
        for (int column = 0; column < test::COLUMNS; ++column)
            ++expected[{40, static_cast<int>(std::floor((39.5 - column) * 0.0505 / 0.05)),
                        static_cast<int>(std::floor((29.5 - row) * 0.0505 / 0.05))}];
    std::map<VoxelCoord, uint32_t> found;
    for (const HitVoxel& h : frame.hits()) {
        found[h.coord] = h.points;
        EXPECT_NEAR(h.centroid.x, 2.02, 1e-5);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(frame.origin(), TPoint3D(0, 0, 0));
    EXPECT_EQ(frame.focalLength(), test::FOCAL);
    EXPECT_EQ(frame.resolution(), RESOLUTION);
}

TEST(VoxelizedFrame, AMaskHoldsItsPixelsWhateverTheyAre)
{
    // The wall above, with a hole that makes no points.
    const auto isHole = [](int column, int row) { return column > 50 && column < 60 && row > 7; };
    const auto depth = [&](int column, int row) { return isHole(column, row) ? 0.0 : 2.02; };
    const VoxelizedFrame frame(frameOf(makeScan(depth)), RESOLUTION, {});
    std::mt19937 random(3);
    for (const unsigned inTen : {1u, 5u, 9u, 10u}) {
        std::vector<uint8_t> bitmap;
        std::map<VoxelCoord, uint32_t> expected;
        for (int row = 0; row < test::ROWS; ++row)
            for (int column = 0; column < test::COLUMNS; ++column) {
                bitmap.push_back(random() % 10 < inTen ? 1 : 0);
                if (bitmap.back() != 0 && !isHole(column, row))
                    ++expected[{40, static_cast<int>(std::floor((39.5 - column) * 0.0505 / 0.05)),
                                static_cast<int>(std::floor((29.5 - row) * 0.0505 / 0.05))}];
            }
        std::map<VoxelCoord, uint32_t> found;
        const auto mask = RunLengthMask::fromBitmap(bitmap.data(), test::COLUMNS, test::ROWS);
        for (const auto& [hit, points] : frame.pointsOf(mask))
            EXPECT_TRUE(found.emplace(frame.hits()[hit].coord, points).second);
        EXPECT_EQ(found, expected);
    }
}

TEST(VoxelizedFrame, TheMeanPointOfAVoxelIsExact)
{
    // Four pixels of 2.01, 2.02, 2.03 and 2.04 m fall in one voxel of 1 m.
    const auto depth = [](int column, int row) {
        return column >= 40 && column < 42 && row < 30 && row >= 28
                   ? 2.01 + 0.01 * (column - 40) + 0.02 * (row - 28)
                   : 0.0;
    };
    const CPose3D pose(-100.25, 50.5, 7.75, 0, 0, 0);
    const VoxelizedFrame frame(frameOf(makeScan(depth), pose), 1.0, {});
    ASSERT_EQ(frame.hits().size(), 1u);
    EXPECT_EQ(frame.hits()[0].points, 4u);
    TPoint3D sum;  // of d, d (39.5 - column) / 40 and d (29.5 - row) / 40, less the pose
    sum.x = 2.01 + 2.02 + 2.03 + 2.04;
    sum.y = (-0.5 * 2.01 - 1.5 * 2.02 - 0.5 * 2.03 - 1.5 * 2.04) / 40;
    sum.z = (1.5 * 2.01 + 1.5 * 2.02 + 0.5 * 2.03 + 0.5 * 2.04) / 40;
    const TPoint3D error =
        frame.hits()[0].centroid - (TPoint3D(pose.x(), pose.y(), pose.z()) + sum * 0.25);
    EXPECT_LT(error.norm(), 2.0 / 65536) << "a fraction of a voxel";
}

TEST(VoxelizedFrame, CentroidsLieInTheirOwnVoxels)
{
    // The optical axis runs along voxel boundaries and is then turned by as little as 1e-12 rad:
    // pixels on it fall right below or above a boundary, alone in their voxels.
    constexpr double EXACT_RESOLUTION = 0.0625;
    std::mt19937 random(5);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    const auto tiny = [&] { return (random() % 2 == 0 ? 1 : -1) * std::pow(10, between(-12, -2)); };
    const auto corner = [&] {
        return (static_cast<int>(random() % 4000) - 2000) * EXACT_RESOLUTION;
    };
    for (int trial = 0; trial < 500; ++trial) {
        const auto scan = makeScan(
            [&](int column, int row) { return column == 40 || row == 30 ? between(0.5, 6) : 0; });
        scan->cameraParams.setIntrinsicParamsFromValues(test::FOCAL, test::FOCAL, 40, 30);
        const CPose3D along(corner(), corner(), corner(), tiny(), tiny(), tiny());
        const CPose3D any(between(-99, 99), between(-99, 99), between(-9, 9), between(-3, 3),
                          between(-1.5, 1.5), between(-3, 3));
        for (const CPose3D& pose : {along, any}) {
            const VoxelizedFrame frame(frameOf(scan, pose), EXACT_RESOLUTION, {});
            ASSERT_FALSE(frame.hits().empty());
            for (const HitVoxel& h : frame.hits())
                ASSERT_EQ(voxelOf(h.centroid, 1 / EXACT_RESOLUTION), h.coord) << pose;
        }
    }
}

TEST(VoxelizedFrame, AgreesWithBruteForceAtAnyPose)
{
    const auto scan = makeScan(bumpy);
    for (const CPose3D& pose :
         {CPose3D(), CPose3D(-3.21, -0.77, 1.03, 0.3, -0.2, 0.1),
          CPose3D(12.3, -45.6, -7.8, 2.9, 0.9, -2.2), CPose3D(-500.013, 820.027, 3, -1.7, 0, 0)})
        expectAsBruteForce(frameOf(scan, pose));
    const auto mounted = makeScan(bumpy);
    mounted->sensorPose = CPose3D(0.1, -0.2, 1.1, 0.5, 0.25, -0.1);
    expectAsBruteForce(frameOf(mounted, CPose3D(-1, -2, -3, 0.4, 0.3, 0.2)));
}

TEST(VoxelizedFrame, RangesMayBeDistancesInsteadOfDepths)
{
    const auto scan = makeScan(bumpy);
    scan->range_is_depth = false;
    expectAsBruteForce(frameOf(scan, CPose3D(-0.3, 0.2, 0.1, 1, 0.2, 0.3)));
}

TEST(VoxelizedFrame, PixelsWithoutDepthOrBeyondTheLimitsMakeNoPoint)
{
    const auto depth = [](int column, int) {
        return column < 20 ? 0.0 : column < 40 ? 0.2 : column < 60 ? 5.0 : 1.52;
    };
    const auto scan = makeScan(depth);
    const auto points = [&](const DepthLimits& limits) {
        uint32_t n = 0;
        const VoxelizedFrame frame(frameOf(scan), RESOLUTION, limits);
        for (const HitVoxel& h : frame.hits()) n += h.points;
        return n;
    };
    constexpr uint32_t QUARTER = test::COLUMNS * test::ROWS / 4;
    EXPECT_EQ(points({0.3, 4.0}), QUARTER);
    EXPECT_EQ(points({0.1, 4.0}), 2 * QUARTER);
    EXPECT_EQ(points({0.1, 6.0}), 3 * QUARTER);
    EXPECT_EQ(points({0.0, 6.0}), 3 * QUARTER) << "zero means not measured, whatever the limit";
    EXPECT_EQ(points({7.0, 8.0}), 0u);
}

TEST(VoxelizedFrame, DepthsMetAreThoseOfTheImageWhateverTheLimits)
{
    // Columns of 0.2 m, nothing, 1 m and 7.5 m, in turn.
    const auto depth = [](int c, int) { return std::array<double, 4>{0.2, 0, 1, 7.5}.at(c % 4); };
    const VoxelizedFrame frame(frameOf(makeScan(depth)), RESOLUTION, {0.3, 4});
    const uint64_t column = test::ROWS * test::COLUMNS / 4;
    EXPECT_EQ(frame.depths().pixels, 3 * column);
    EXPECT_EQ(frame.depths().used, column);
    EXPECT_NEAR(frame.depths().nearest, 0.2, 1e-6);
    EXPECT_NEAR(frame.depths().farthest, 7.5, 1e-6);
    DepthsMet both = frame.depths();
    both.add(
        VoxelizedFrame(frameOf(makeScan([](int, int) { return 0.1; })), RESOLUTION, {}).depths());
    EXPECT_EQ(both.pixels, 7 * column);
    EXPECT_EQ(both.used, column);
    EXPECT_NEAR(both.nearest, 0.1, 1e-6);
    EXPECT_NEAR(both.farthest, 7.5, 1e-6);
}

TEST(VoxelizedFrame, UnusableScansAreRefused)
{
    const auto refused = [](const std::function<void(CObservation3DRangeScan&)>& spoil) {
        const auto scan = makeScan([](int, int) { return 1.0; });
        spoil(*scan);
        EXPECT_THROW(VoxelizedFrame(frameOf(scan), RESOLUTION, {}), InputError);
    };
    refused([](auto& s) { s.hasRangeImage = false; });
    refused([](auto& s) { s.cameraParams.ncols = 81; });
    refused([](auto& s) { s.cameraParams.setIntrinsicParamsFromValues(0, 40, 39.5, 29.5); });
    refused([](auto& s) { s.cameraParams.setIntrinsicParamsFromValues(40, -40, 39.5, 29.5); });
    refused([](auto& s) { s.cameraParams.setIntrinsicParamsFromValues(NAN, 40, 39.5, 29.5); });
    refused([](auto& s) { s.cameraParams.setIntrinsicParamsFromValues(40, 40, NAN, 29.5); });
    refused([](auto& s) { s.rangeUnits = 0; });
    refused([](auto& s) { s.rangeUnits = NAN; });
    refused([](auto& s) { s.sensorPose.x(NAN); });
    refused([](auto& s) { s.sensorPose.x(1e9); });
}

TEST(VoxelizedFrame, PredictionsForImagesOfAnotherSizeAreRefused)
{
    RgbdFrame frame = frameOf(makeScan([](int, int) { return 1.0; }));
    const auto predictions = test::makePredictions({});
    predictions->imageWidth = 640;
    frame.instances = predictions;
    try {
        VoxelizedFrame(frame, RESOLUTION, {});
        FAIL() << "accepted";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("640x60"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("80x60"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("'camera'"), std::string::npos);
    }
}

TEST(VoxelizedFrame, ACameraOfAnotherSizeIsRefused)
{
    auto scan = test::makeScan([](int, int) { return 1.0; });
    scan->cameraParams.cx(test::COLUMNS);  // as of twice the width
    try {
        VoxelizedFrame({scan, nullptr, {}}, 0.05, {});
        FAIL() << "nothing was thrown";
    } catch (const UnusableFrame& e) {
        EXPECT_NE(std::string(e.what()).find("of another size"), std::string::npos) << e.what();
    }
    scan->cameraParams.cx(0.2 * test::COLUMNS);  // cut out of a larger image
    EXPECT_NO_THROW(VoxelizedFrame({scan, nullptr, {}}, 0.05, {}));
}

TEST(VoxelizedFrame, AnEmptyDepthImageIsRefused)
{
    const auto scan = makeScan([](int, int) { return 1.0; });
    scan->rangeImage_setSize(0, 0);
    scan->cameraParams.ncols = scan->cameraParams.nrows = 0;
    scan->hasIntensityImage = true;
    scan->cameraParamsIntensity = makeScan([](int, int) { return 1.0; })->cameraParams;
    const RgbdFrame frame{scan,
                          test::makePredictions({test::prediction(
                              test::rectangleMask(0, 0, test::COLUMNS, test::ROWS), "cup")}),
                          CPose3D()};
    try {
        VoxelizedFrame(frame, RESOLUTION, DepthLimits());
        FAIL();
    } catch (const UnusableFrame& e) {
        EXPECT_NE(std::string(e.what()).find("empty depth image"), std::string::npos) << e.what();
    }
}
