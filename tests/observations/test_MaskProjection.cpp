// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/VoxelizedFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace voxeland;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

namespace
{
constexpr double RESOLUTION = 0.05;
constexpr double WALL = 2.02;  // [m]

/** Points of a mask by voxel. */
std::map<VoxelCoord, uint32_t> pointsOf(const VoxelizedFrame& frame, const RunLengthMask& mask)
{
    std::map<VoxelCoord, uint32_t> points;
    for (const auto& [hit, n] : frame.pointsOf(mask))
        EXPECT_TRUE(points.emplace(frame.hits()[hit].coord, n).second) << "a voxel twice";
    return points;
}

VoxelCoord wallVoxel(int column, int row)
{
    return voxelOf(TPoint3D(WALL, (test::CENTER_X - column) / test::FOCAL * WALL,
                            (test::CENTER_Y - row) / test::FOCAL * WALL),
                   1 / RESOLUTION);
}

/** A wall seen by a colour camera of its own: 200x120 pixels, f = 90, 12 cm to the right of the
 *  depth camera and turned by 5 degrees to the left. */
struct OtherColourCamera
{
    static constexpr int WIDTH = 200, HEIGHT = 120;
    static constexpr double FOCAL = 90, CX = 103, CY = 57, OFFSET = 0.12, TURN = 5 * M_PI / 180;

    RgbdFrame frame;

    OtherColourCamera()
    {
        const auto scan = test::makeScan([](int, int) { return WALL; });
        scan->hasIntensityImage = true;
        scan->cameraParamsIntensity.ncols = WIDTH;
        scan->cameraParamsIntensity.nrows = HEIGHT;
        scan->cameraParamsIntensity.setIntrinsicParamsFromValues(FOCAL, FOCAL, CX, CY);
        scan->relativePoseIntensityWRTDepth =
            CPose3D(0, -OFFSET, 0, TURN, 0, 0) + CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
        const auto predictions = test::makePredictions({});
        predictions->imageWidth = WIDTH;
        predictions->imageHeight = HEIGHT;
        frame = {scan, predictions, CPose3D()};
    }

    /** Where the colour camera sees a point of the wall: its column and row. */
    static std::pair<double, double> pixelOf(const TPoint3D& p)
    {
        const double x = p.x, y = p.y + OFFSET;  // from the colour camera, axes of the depth camera
        const double ahead = std::cos(TURN) * x + std::sin(TURN) * y;
        const double left = -std::sin(TURN) * x + std::cos(TURN) * y;
        return {CX - FOCAL * left / ahead, CY - FOCAL * p.z / ahead};
    }
};
}  // namespace

TEST(MaskProjection, ARegisteredMaskTakesItsOwnPixels)
{
    RgbdFrame frame;
    frame.scan = test::makeScan([](int c, int) { return c < 12 ? 0.0 : WALL; });
    frame.instances = test::makePredictions({});
    const VoxelizedFrame voxels(frame, RESOLUTION, {});
    std::map<VoxelCoord, uint32_t> expected;
    for (int row = 20; row < 35; ++row)
        for (int column = 12; column < 40; ++column) ++expected[wallVoxel(column, row)];
    EXPECT_EQ(pointsOf(voxels, test::rectangleMask(10, 20, 40, 35)), expected);
    EXPECT_TRUE(pointsOf(voxels, test::rectangleMask(0, 0, 12, 60)).empty());
    EXPECT_TRUE(pointsOf(voxels, test::rectangleMask(0, 0, 0, 0)).empty());
}

TEST(MaskProjection, AWholeImageHoldsAllPoints)
{
    RgbdFrame frame;
    frame.scan = test::makeScan([](int c, int r) { return 1 + 0.01 * c + 0.003 * r; });
    const VoxelizedFrame voxels(frame, RESOLUTION, {});
    const auto points = pointsOf(voxels, test::rectangleMask(0, 0, test::COLUMNS, test::ROWS));
    ASSERT_EQ(points.size(), voxels.hits().size());
    for (const HitVoxel& h : voxels.hits()) EXPECT_EQ(points.at(h.coord), h.points);
}

TEST(MaskProjection, MasksOfAnotherCameraLandOnTheRightVoxels)
{
    const OtherColourCamera camera;
    const VoxelizedFrame voxels(camera.frame, RESOLUTION, {});
    const int left = 80, top = 40, right = 121, bottom = 72;
    std::map<VoxelCoord, uint32_t> expected;
    for (int row = 0; row < test::ROWS; ++row)
        for (int column = 0; column < test::COLUMNS; ++column) {
            const TPoint3D p(WALL, (test::CENTER_X - column) / test::FOCAL * WALL,
                             (test::CENTER_Y - row) / test::FOCAL * WALL);
            const auto [u, v] = OtherColourCamera::pixelOf(p);
            const bool inside =
                u >= left - 0.5 && u < right - 0.5 && v >= top - 0.5 && v < bottom - 0.5;
            if (inside) ++expected[wallVoxel(column, row)];
        }
    ASSERT_GT(expected.size(), 100u);
    EXPECT_EQ(
        pointsOf(voxels, test::rectangleMask(left, top, right, bottom, OtherColourCamera::WIDTH,
                                             OtherColourCamera::HEIGHT)),
        expected);
}

TEST(MaskProjection, PixelsTheColourCameraDoesNotSeeBelongToNoMask)
{
    const OtherColourCamera camera;
    const VoxelizedFrame voxels(camera.frame, RESOLUTION, {});
    uint32_t expected = 0, found = 0;
    for (int row = 0; row < test::ROWS; ++row)
        for (int column = 0; column < test::COLUMNS; ++column) {
            const TPoint3D p(WALL, (test::CENTER_X - column) / test::FOCAL * WALL,
                             (test::CENTER_Y - row) / test::FOCAL * WALL);
            const auto [u, v] = OtherColourCamera::pixelOf(p);
            expected += u >= -0.5 && u < OtherColourCamera::WIDTH - 0.5 && v >= -0.5 &&
                                v < OtherColourCamera::HEIGHT - 0.5
                            ? 1
                            : 0;
        }
    const auto all = test::rectangleMask(0, 0, OtherColourCamera::WIDTH, OtherColourCamera::HEIGHT,
                                         OtherColourCamera::WIDTH, OtherColourCamera::HEIGHT);
    for (const auto& [voxel, n] : pointsOf(voxels, all)) found += n;
    EXPECT_EQ(found, expected);
    EXPECT_LT(found, static_cast<uint32_t>(test::COLUMNS * test::ROWS));
}

TEST(MaskProjection, MasksOfAnotherSizeThanTheirImageAreRefused)
{
    const auto refusal = [](const VoxelizedFrame& frame, int width, int height) -> std::string {
        try {
            (void)frame.pointsOf(test::rectangleMask(0, 0, 8, 8, width, height));
        } catch (const InputError& e) {
            return e.what();
        }
        return "accepted";
    };
    RgbdFrame wall;
    wall.scan = test::makeScan([](int, int) { return WALL; });
    const VoxelizedFrame depthOnly(wall, RESOLUTION, {});
    EXPECT_EQ(refusal(depthOnly, test::COLUMNS, test::ROWS), "accepted");
    for (const auto& [width, height] :
         {std::pair(test::COLUMNS, test::ROWS + 1), std::pair(test::ROWS, test::COLUMNS)})
    {
        const std::string message = refusal(depthOnly, width, height);
        EXPECT_NE(message.find(std::to_string(width) + "x" + std::to_string(height)),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find("80x60"), std::string::npos) << message;
    }

    const VoxelizedFrame projected(OtherColourCamera().frame, RESOLUTION, {});
    EXPECT_EQ(refusal(projected, OtherColourCamera::WIDTH, OtherColourCamera::HEIGHT), "accepted");
    EXPECT_NE(refusal(projected, test::COLUMNS, test::ROWS).find("200x120"), std::string::npos);
}
