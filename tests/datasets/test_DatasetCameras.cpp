// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/errors.h"
#include "voxeland/datasets/DatasetCameras.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
const std::vector<ImageSize> SCANNET = {{1296, 968}, {640, 480}};

struct Fit
{
    PinholeCamera camera;
    std::vector<std::string> notes;
};

Fit fit(const PinholeCamera& camera, const ImageSize& images,
        const std::vector<ImageSize>& recorded = {})
{
    Fit fit;
    fit.camera = fittedCamera(camera, images, recorded, "the images", "--intrinsics", fit.notes);
    return fit;
}
}  // namespace

TEST(DatasetCameras, ThatOfItsOwnImagesStays)
{
    // Centres of real cameras: TUM's freiburg1, ScanNet's colour and depth, a phone's.
    for (const auto& [cx, cy, images] : {std::tuple{318.643, 255.314, ImageSize{640, 480}},
                                         std::tuple{646.295, 489.927, ImageSize{1296, 968}},
                                         std::tuple{319.5, 239.5, ImageSize{640, 480}},
                                         std::tuple{957.0, 730.0, ImageSize{1920, 1440}}})
    {
        const Fit same = fit({500, 501, cx, cy, {}}, images, SCANNET);
        EXPECT_EQ(same.camera.cx, cx);
        EXPECT_EQ(same.camera.cy, cy);
        EXPECT_EQ(same.camera.fx, 500);
        EXPECT_EQ(same.camera.fy, 501);
        EXPECT_TRUE(same.notes.empty());
    }
}

TEST(DatasetCameras, ThatOfARecordedSizeIsScaledToTheImages)
{
    const PinholeCamera scanNet = {1169.62, 1167.1, 646.295, 489.927, {}};
    for (const ImageSize images : {ImageSize{972, 726}, ImageSize{640, 480}, ImageSize{324, 242}}) {
        const Fit scaled = fit(scanNet, images, SCANNET);
        const double x = images.width / 1296.0, y = images.height / 968.0;
        EXPECT_NEAR(scaled.camera.fx, 1169.62 * x, 1e-9);
        EXPECT_NEAR(scaled.camera.fy, 1167.1 * y, 1e-9);
        EXPECT_NEAR(scaled.camera.cx, 646.795 * x - 0.5, 1e-9);
        EXPECT_NEAR(scaled.camera.cy, 490.427 * y - 0.5, 1e-9);
        ASSERT_EQ(scaled.notes.size(), 1U);
        EXPECT_EQ(scaled.notes[0], "the images have " + images.text() +
                                       " pixels, but their camera is of 1296x968: its intrinsics "
                                       "are scaled (--intrinsics gives others)");
    }
    // A pixel's ray stays: the left edge of the images is where it was.
    const Fit half = fit({585, 585, 319.5, 239.5, {}}, {320, 240}, SCANNET);
    EXPECT_NEAR((-0.5 - half.camera.cx) / half.camera.fx, (-0.5 - 319.5) / 585, 1e-12);
}

TEST(DatasetCameras, TheSizeThatComesWithACameraHolds)
{
    EXPECT_EQ(fit({500, 500, 100, 300, {}, {800, 600}}, {800, 600}).camera.cx, 100);
    EXPECT_EQ(fit({500, 500, 99.5, 299.5, {}, {800, 600}}, {400, 300}).camera.cy, 149.5);
}

TEST(DatasetCameras, WhatCannotBeToldIsRefused)
{
    const auto refusal = [](const PinholeCamera& camera, const ImageSize& images) {
        try {
            static_cast<void>(fit(camera, images, SCANNET));
        } catch (const InputError& e) {
            EXPECT_LT(std::string(e.what()).size(), 300U);
            return std::string(e.what());
        }
        return std::string();
    };
    // Three quarters of 1280x720, whose size is nowhere written.
    EXPECT_NE(refusal({900, 900, 640, 360, {}}, {960, 540}).find("centred at (640, 360)"),
              std::string::npos);
    EXPECT_NE(refusal({900, 900, 640, 360, {}}, {960, 540}).find("--intrinsics"),
              std::string::npos);
    // 16:9 of a 4:3 camera: the upper and lower part cut off, or squeezed?
    EXPECT_NE(
        refusal({585, 585, 320, 240, {}, {640, 480}}, {640, 360}).find("cropped or stretched"),
        std::string::npos);
}
