// SPDX-License-Identifier: BSD-3-Clause
/** The closed form against its integral, and against points that are really displaced. */
#include "evidence/Displacement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using voxeland::probabilityOfStaying;

TEST(Displacement, IsTheMeanShareOfAVoxelThatOverlapsItself)
{
    for (const double s : {0.02, 0.1, 0.3, 1.0, 4.0}) {  // standard deviation along an axis [edges]
        // Midpoint rule over the errors t that leave anything inside.
        constexpr int STEPS = 200000;
        double integral = 0;
        for (int i = 0; i < STEPS; ++i) {
            const double t = -1 + 2 * (i + 0.5) / STEPS;
            integral += (1 - std::abs(t)) * std::exp(-t * t / (2 * s * s)) * 2 / STEPS;
        }
        const double alongOneAxis = integral / (s * std::sqrt(2 * M_PI));
        EXPECT_NEAR(probabilityOfStaying(std::sqrt(3) * s * 0.05, 0.05), std::pow(alongOneAxis, 3),
                    1e-6)
            << s;
    }
}

TEST(Displacement, IsHowManyPointsStayInTheirVoxel)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(0, 0.1);
    for (const double rms : {0.01, 0.05, 0.2}) {
        std::normal_distribution<double> error(0, rms / std::sqrt(3));
        constexpr int POINTS = 400000;
        int stayed = 0;
        for (int i = 0; i < POINTS; ++i) {
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
                const double p = place(random) + error(random);
                inside = inside && p >= 0 && p < 0.1;
            }
            stayed += inside ? 1 : 0;
        }
        const double expected = probabilityOfStaying(rms, 0.1);
        const double sigma = std::sqrt(expected * (1 - expected) / POINTS);
        EXPECT_NEAR(stayed / static_cast<double>(POINTS), expected, 5 * sigma) << rms;
    }
}

TEST(Displacement, FallsFromOneToAlmostNothing)
{
    EXPECT_EQ(probabilityOfStaying(0, 0.05), 1);
    double last = 1;
    for (double displacement = 1e-6; displacement < 1e6; displacement *= 1.5) {
        const double now = probabilityOfStaying(displacement, 0.05);
        EXPECT_LT(now, last);
        EXPECT_GT(now, 0);
        last = now;
    }
    // Far away, one axis keeps edge / (sigma sqrt(2 pi)) of the points.
    const double sigma = 100 / std::sqrt(3);
    EXPECT_NEAR(probabilityOfStaying(100, 0.05) / std::pow(0.05 / (sigma * std::sqrt(2 * M_PI)), 3),
                1, 1e-3);
}
