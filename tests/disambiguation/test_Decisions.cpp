// SPDX-License-Identifier: BSD-3-Clause
#include "UncertainMap.h"
#include "disambiguation/Decisions.h"
#include "support/MapBytes.h"
#include "voxeland/map/MapQueries.h"

#include <gtest/gtest.h>

#include <random>

using namespace voxeland;
using test::bytesOf;

namespace
{
Decision decisionFor(category_id_t category)
{
    Decision d;
    d.category = category;
    d.source = "voxeland::CNobody";
    d.answer = "The object category is ...";
    d.time = mrpt::Clock::fromDouble(1e9);
    return d;
}

SemanticVoxelMap randomMap(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> beta(0, 20);
    SemanticVoxelMap map;
    for (int i = 0; i < 10; ++i) test::addInstance(map, beta(random), beta(random), beta(random));
    return map;
}
}  // namespace

TEST(Decisions, WeighAsMuchAsTheOptionsSay)
{
    SemanticVoxelMap map;  // prior 2, spread over 3 categories
    test::addInstance(map, 6, 3, 1);
    DisambiguationOptions options;
    options.decision_weight = 2;
    decide(map, 1, decisionFor(2), options);
    EXPECT_DOUBLE_EQ(map.instance(1).decisions.at(0).evidence, 2 * (10 + 2));
    const auto ranked = categoryDistribution(map, map.instance(1));
    EXPECT_EQ(ranked.front().name, "bed");
    EXPECT_NEAR(ranked.front().probability, (1 + 2.0 / 3 + 24) / 36, 1e-12);
}

TEST(Decisions, WinWhateverTheOthersHave)
{
    for (unsigned seed = 0; seed < 10; ++seed)
        for (const category_id_t category : {0U, 1U, 2U, UNKNOWN_CATEGORY_ID}) {
            auto map = randomMap(seed);
            for (const auto& [id, instance] : map.instances())
                decide(map, id, decisionFor(category), {});
            for (const auto& [id, instance] : map.instances())
                EXPECT_EQ(categoryDistribution(map, instance).front().category, category);
        }
}

TEST(Decisions, AreTakenBackToTheByte)
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        auto map = randomMap(seed);
        const std::string before = bytesOf(map);
        for (const instance_id_t id : {3U, 5U, 3U}) decide(map, id, decisionFor(id % 3), {});
        EXPECT_NE(bytesOf(map), before);
        EXPECT_EQ(undoDecisions(map, 3), 2U);
        EXPECT_EQ(undoDecisions(map, 3), 0U);
        EXPECT_EQ(map.instance(5).decisions.size(), 1U);
        EXPECT_EQ(undoDecisions(map, std::nullopt), 1U);
        EXPECT_EQ(bytesOf(map), before);
    }
}

TEST(Decisions, OfAMergedInstanceAreFoundByItsOldNumber)
{
    auto map = randomMap(1);
    decide(map, 4, decisionFor(1), {});
    map.merge(7, 4, 0);
    EXPECT_EQ(map.instance(7).decisions.size(), 1U);
    EXPECT_EQ(undoDecisions(map, 4), 1U);
    EXPECT_TRUE(map.instance(7).decisions.empty());
}
