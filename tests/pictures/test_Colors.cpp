// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/Colors.h"
#include "voxeland/map/SemanticVoxelMap.h"

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

TEST(Colors, instancesDifferFromEachOtherAndFromGrey)
{
    SemanticVoxelMap map;
    for (int i = 0; i < 20; ++i) map.addEvidence({i, 0, 0}, map.createInstance().id, 1);
    const auto colors = instanceColors(map);
    ASSERT_EQ(colors.size(), 21U);
    EXPECT_EQ(colors.at(UNKNOWN_INSTANCE), UNKNOWN_COLOR);
    for (const auto& [id, c] : colors) {
        if (id == UNKNOWN_INSTANCE) continue;
        for (const auto& [other, otherColor] : colors)
            if (other != id) {
                EXPECT_GT(distance(c, otherColor), 50) << id << " and " << other;
            }
        const auto [least, most] = std::minmax({c.red, c.green, c.blue});
        EXPECT_GT(most - least, 80) << id << " is nearly grey";
    }
}

/** Whatever small instances there are besides. */
TEST(Colors, theBiggestInstancesKeepTheirs)
{
    SemanticVoxelMap map;
    const auto addInstance = [&](int size) {
        const auto id = map.createInstance().id;
        for (int x = 0; x < size; ++x) map.addEvidence({x, static_cast<int>(id), 0}, id, 1);
        return id;
    };
    const auto first = addInstance(30), second = addInstance(20);
    const auto before = instanceColors(map);
    for (int i = 0; i < 40; ++i) addInstance(2);
    const auto after = instanceColors(map);
    EXPECT_EQ(after.at(first), before.at(first));
    EXPECT_EQ(after.at(second), before.at(second));
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
