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

TEST(Decisions, AreEvidenceByBayesRuleOfAWitness)
{
    MapOptions mapOptions;
    mapOptions.prior_strength = 2;  // spread over 3 categories
    SemanticVoxelMap map(mapOptions);
    test::addInstance(map, 6, 3, 1);
    DisambiguationOptions options;
    options.answer_reliability = 0.75;
    options.max_categories = 3;
    decide(map, 1, decisionFor(2), options);
    // bed has (1 + 2/3)/12 = 5/36: 3/4 of it and 1/16 are 1/6, three to one and five times 1/12.
    const double after = (3.0 / 4 / 6) / (3.0 / 4 / 6 + 1.0 / 4 / 3 * 5 / 6);
    const auto ranked = categoryDistribution(map, map.instance(1));
    EXPECT_EQ(ranked.front().name, "bed");
    EXPECT_NEAR(ranked.front().probability, after, 1e-12);
}

TEST(Decisions, WinWhereTheMapIsUnsure)
{
    for (const category_id_t category : {0U, 1U, 2U, UNKNOWN_CATEGORY_ID}) {
        SemanticVoxelMap map;
        const instance_id_t id = test::addInstance(map, 5, 4, 3);
        decide(map, id, decisionFor(category), {});
        EXPECT_EQ(categoryDistribution(map, map.instance(id)).front().category, category);
    }
}

TEST(Decisions, OfOneWitnessDoNotOverturnWhatTheMapIsSureOf)
{
    for (const double scale : {1.0, 10.0, 100.0}) {
        MapOptions mapOptions;
        mapOptions.prior_strength = 0;
        SemanticVoxelMap map(mapOptions);
        const instance_id_t id = test::addInstance(map, 0.86 * scale, 0.14 * scale, 0);
        const auto winner = [&] { return categoryDistribution(map, map.instance(id)).front(); };
        decide(map, id, decisionFor(UNKNOWN_CATEGORY_ID), {});
        EXPECT_EQ(winner().name, "chair") << scale;
        EXPECT_LT(winner().probability, 0.7);
        decide(map, id, decisionFor(UNKNOWN_CATEGORY_ID), {});
        EXPECT_EQ(winner().category, UNKNOWN_CATEGORY_ID) << "two witnesses agree";
        const double twice = winner().probability;
        decide(map, id, decisionFor(UNKNOWN_CATEGORY_ID), {});
        EXPECT_GT(winner().probability, twice);
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
