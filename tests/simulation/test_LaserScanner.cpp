// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/LaserScanner.h"

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>

#include <cmath>

using namespace voxeland::simulation;
using mrpt::math::TPose2D;

namespace
{
/** Three rays, 45 degrees to the right, ahead, and to the left, without noise. */
RobotOptions threeRays()
{
    RobotOptions options;
    options.laserAperture = 90;
    options.laserRays = 3;
    options.laserSigma = 0;
    return options;
}

Solid box(const Vector3& center, const Vector3& halfSize)
{
    return {Solid::Shape::Box, {center.x, center.y, center.z, 0, 0, 0}, halfSize, {}};
}

std::vector<float> scan(const Scene& scene, const RobotOptions& options, const TPose2D& robot)
{
    Random noise(1);
    return LaserScanner(scene, options).measure(robot, noise);
}
}  // namespace

TEST(LaserScanner, MeasuresFromTheRightToTheLeft)
{
    Scene scene;
    scene.addSolid(box({3, 0, 0.5F}, {0.5F, 4, 0.5F}));  // ahead, at 2.5 m
    scene.addSolid(box({0, 2, 0.5F}, {4, 0.5F, 0.5F}));  // to the left, at 1.5 m
    const auto ranges = scan(scene, threeRays(), {0, 0, 0});
    ASSERT_EQ(ranges.size(), 3U);
    EXPECT_NEAR(ranges[0], 2.5 * std::sqrt(2), 1e-5);
    EXPECT_NEAR(ranges[1], 2.5, 1e-5);
    EXPECT_NEAR(ranges[2], 1.5 * std::sqrt(2), 1e-5);
}

TEST(LaserScanner, TurnsWithTheRobot)
{
    Scene scene;
    scene.addSolid(box({0, 2, 0.5F}, {0.1F, 0.5F, 0.5F}));
    const auto ranges = scan(scene, threeRays(), {0, 0.25, mrpt::DEG2RAD(45.0)});
    EXPECT_EQ(ranges[0], 0);
    EXPECT_EQ(ranges[1], 0);
    EXPECT_NEAR(ranges[2], 1.25, 1e-5);
}

TEST(LaserScanner, SeesOnlyWhatReachesItsHeight)
{
    RobotOptions options = threeRays();
    options.laserHeight = 0.3F;
    Scene low, high;
    low.addSolid(box({2, 0, 0.1F}, {0.5F, 5, 0.1F}));
    high.addSolid(box({2, 0, 1}, {0.5F, 5, 0.1F}));
    EXPECT_EQ(scan(low, options, {})[1], 0);
    EXPECT_EQ(scan(high, options, {})[1], 0);
    high.addSolid(box({3, 0, 0.3F}, {0.5F, 5, 0.01F}));
    EXPECT_NEAR(scan(high, options, {})[1], 2.5, 1e-5);
}

TEST(LaserScanner, TellsNothingBeyondItsReach)
{
    RobotOptions options = threeRays();
    options.laserMaxRange = 3;
    Scene scene;
    scene.addSolid(box({3, 0, 0.5F}, {0.5F, 5, 0.5F}));
    const auto ranges = scan(scene, options, {});
    EXPECT_EQ(ranges[0], 0) << "3.54 m";
    EXPECT_NEAR(ranges[1], 2.5, 1e-5);
}

TEST(LaserScanner, ErrsAsMuchAsItShould)
{
    RobotOptions options = threeRays();
    options.laserSigma = 0.02F;
    Scene scene;
    scene.addSolid(box({3, 0, 0.5F}, {0.5F, 5, 0.5F}));
    const LaserScanner laser(scene, options);
    Random noise(3);
    double sum = 0, squares = 0;
    constexpr int N = 2000;
    for (int i = 0; i < N; ++i) {
        const double error = static_cast<double>(laser.measure({}, noise)[1]) - 2.5;
        sum += error;
        squares += error * error;
    }
    EXPECT_NEAR(sum / N, 0, 0.002);
    EXPECT_NEAR(std::sqrt(squares / N), 0.02, 0.002);
}
