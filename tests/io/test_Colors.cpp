// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/Colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace voxeland;

namespace
{
double distance(const Color& a, const Color& b)
{
    return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
}
}  // namespace

TEST(Colors, instancesDifferFromNeighboursAndFromGrey)
{
    for (instance_id_t id = 1; id < 300; ++id) {
        const Color c = instanceColor(id);
        for (instance_id_t other = id + 1; other < id + 6; ++other)
            EXPECT_GT(distance(c, instanceColor(other)), 50) << id << " and " << other;
        const auto [least, most] = std::minmax({c.red, c.green, c.blue});
        EXPECT_GT(most - least, 80) << id << " is nearly grey";
    }
    EXPECT_EQ(instanceColor(UNKNOWN_INSTANCE), UNKNOWN_COLOR);
}

TEST(Colors, categoriesDiffer)
{
    std::set<std::string> names;
    for (int i = 0; i < 12; ++i) names.insert("category " + std::to_string(i));
    const auto colors = categoryColors(names);
    ASSERT_EQ(colors.size(), names.size());
    for (const auto& [a, colorA] : colors)
        for (const auto& [b, colorB] : colors) {
            if (a != b) {
                EXPECT_GT(distance(colorA, colorB), 80) << a << " and " << b;
            }
        }
    EXPECT_EQ(categoryColors(names), colors);
}

TEST(Colors, moreCategoriesThanTonesStillHaveColours)
{
    std::set<std::string> names;
    for (int i = 0; i < 200; ++i) names.insert(std::to_string(i));
    EXPECT_EQ(categoryColors(names).size(), 200U);
}

TEST(Colors, uncertaintyGoesFromBlueToRed)
{
    const Color low = uncertaintyColor(0), middle = uncertaintyColor(0.5),
                high = uncertaintyColor(1);
    EXPECT_GT(low.blue, 200);
    EXPECT_LT(low.red, 60);
    EXPECT_GT(middle.green, 200);
    EXPECT_GT(high.red, 200);
    EXPECT_LT(high.blue, 60);
    EXPECT_EQ(uncertaintyColor(7), high);
    EXPECT_EQ(uncertaintyColor(-1), low);
}
