// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/DepthNoise.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland::simulation;

namespace
{
const RenderCamera CAMERA{CameraOptions{}};

RenderedView wallAt(float z)
{
    RenderedView view;
    view.depth.assign(CAMERA.pixels(), z);
    view.cosines.assign(CAMERA.pixels(), 1);
    return view;
}

struct Statistics
{
    double mean = 0, sigma = 0, valid = 0;
};

Statistics measure(float z, const DepthNoiseOptions& options)
{
    Random random(5);
    double sum = 0, squares = 0, n = 0;
    for (const uint16_t mm : measureDepth(wallAt(z), CAMERA, options, random)) {
        if (mm == 0) continue;
        const double error = mm / 1000.0 - static_cast<double>(z);
        sum += error;
        squares += error * error;
        ++n;
    }
    const double mean = sum / n;
    return {mean, std::sqrt(squares / n - mean * mean), n / static_cast<double>(CAMERA.pixels())};
}
}  // namespace

TEST(DepthNoise, SigmaFollowsTheKinectModel)
{
    // 0.0012 + 0.0019 (z - 0.4)^2
    EXPECT_NEAR(axialSigma({}, 0.4F), 0.0012, 1e-7);
    EXPECT_NEAR(axialSigma({}, 1.4F), 0.0031, 1e-7);
    EXPECT_NEAR(axialSigma({}, 3.4F), 0.0183, 1e-7);
}

TEST(DepthNoise, HasThePromisedMeanAndSpread)
{
    DepthNoiseOptions options;
    options.disparityStep = 0;
    for (const auto& [z, sigma] : {std::pair{1.0F, 0.001884}, {2.0F, 0.006064}, {3.0F, 0.014044}}) {
        const Statistics s = measure(z, options);
        // Rounding to millimetres adds a variance of (1 mm)^2 / 12.
        const double expected = std::sqrt(sigma * sigma + 1e-6 / 12);
        EXPECT_NEAR(s.mean, 0, 5 * expected / std::sqrt(300000.0)) << z;
        EXPECT_NEAR(s.sigma, expected, 0.01 * expected) << z;
        EXPECT_NEAR(s.valid, 1 - options.randomDropout, 0.001);
    }
}

TEST(DepthNoise, QuantizesDisparity)
{
    DepthNoiseOptions options;
    options.axialConstant = options.axialFactor = 0;
    Random random(1);
    // f b = 525 * 0.075 = 39.375 m px. At 2.1 m the disparity is 18.75 px, a multiple of 1/8 px;
    // at 2.105 m it is 18.7055, rounded to 18.75.
    for (const uint16_t mm : measureDepth(wallAt(2.105F), CAMERA, options, random))
        if (mm != 0) {
            ASSERT_EQ(mm, 2100);
        }
}

TEST(DepthNoise, MeasuresNothingOutOfRangeOrAtGrazingAngles)
{
    EXPECT_TRUE(std::isnan(measure(0.4F, {}).mean));
    EXPECT_TRUE(std::isnan(measure(6.1F, {}).mean));
    auto view = wallAt(2);
    view.cosines.assign(CAMERA.pixels(), 0.1F);
    Random random(1);
    for (const uint16_t mm : measureDepth(view, CAMERA, {}, random)) ASSERT_EQ(mm, 0);
}

TEST(DepthNoise, LosesPixelsAtEdges)
{
    auto view = wallAt(2);
    for (size_t i = 0; i < CAMERA.pixels(); ++i)
        if (i % 640 >= 320) view.depth[i] = 3;
    DepthNoiseOptions options;
    options.lateralSigma = 0;
    Random random(1);
    const auto measured = measureDepth(view, CAMERA, options, random);
    int lost = 0;
    for (size_t row = 0; row < 480; ++row)
        for (const size_t column : {319U, 320U}) lost += measured[row * 640 + column] == 0 ? 1 : 0;
    EXPECT_NEAR(lost / 960.0, 0.5, 5 * std::sqrt(0.25 / 960));
}

TEST(DepthNoise, SwitchedOffGivesTheExactDepth)
{
    DepthNoiseOptions options;
    options.enabled = false;
    Random random(1);
    for (const uint16_t mm : measureDepth(wallAt(1.2344F), CAMERA, options, random))
        ASSERT_EQ(mm, 1234);
}
