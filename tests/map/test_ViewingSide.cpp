// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/ViewingSide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace voxeland;
using mrpt::math::TPoint3Df;

namespace
{
/** A camera on a circle around a chair, that looks at it. */
side_t fromAround(float degrees, float distance)
{
    const float angle = degrees * static_cast<float>(M_PI / 180);
    const TPoint3Df chair(1, 2, 0.5F);
    return sideOf(chair + TPoint3Df(std::cos(angle), std::sin(angle), 0.1F) * distance, chair);
}
}  // namespace

TEST(ViewingSide, TheSameWithinAFewDegreesAndAnotherFarRound)
{
    EXPECT_EQ(fromAround(0, 1.5F), fromAround(5, 1.5F));
    EXPECT_NE(fromAround(0, 1.5F), fromAround(45, 1.5F));
    EXPECT_NE(fromAround(0, 1.5F), fromAround(180, 1.5F));
    std::set<side_t> met;
    for (int degrees = 0; degrees < 360; ++degrees)
        met.insert(fromAround(static_cast<float>(degrees), 1.5F));
    EXPECT_GE(met.size(), 10U);
    EXPECT_LE(met.size(), 16U) << "some 25 degrees wide";
}

TEST(ViewingSide, AnOctaveOfDistancesIsOne)
{
    const auto at = [](float distance) { return sideOf({0, 0, 0}, {distance, 0, 0}); };
    EXPECT_EQ(at(1), at(1.99F));
    EXPECT_NE(at(1.99F), at(2.01F));
    EXPECT_NE(at(0.9F), at(1.1F));
    EXPECT_EQ(at(300), at(1e6F)) << "beyond the last";
    EXPECT_EQ(at(0.001F), at(0.003F)) << "before the first";
    EXPECT_LT(sideOf({1, 1, 1}, {1, 1, 1}), SIDES) << "no distance at all";
}

TEST(ViewingSide, NumbersAreInRange)
{
    std::mt19937 random(2);
    std::normal_distribution<float> coordinate(0, 3);
    for (int i = 0; i < 10000; ++i) {
        const TPoint3Df a(coordinate(random), coordinate(random), coordinate(random));
        const TPoint3Df b(coordinate(random), coordinate(random), coordinate(random));
        const side_t side = sideOf(a, b);
        ASSERT_LT(side, SIDES);
        ASSERT_LT(sectorOf(viewingDirection(a, b)), 125);
        ASSERT_NEAR(viewingDirection(a, b).norm(), 1, 1e-5);
    }
}
