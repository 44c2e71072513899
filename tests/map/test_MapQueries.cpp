// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MapQueries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace voxeland;

namespace
{
constexpr double RESOLUTION = 0.1;

/** Instance 1: chair 3, sofa 1. Instance 2: table 2. One more category is known, but to no one.
 *  Voxel (0,0,0): 1 with 6, 2 with 3, unknown with 1; voxel (-1,0,0): 1 with 2; voxel (4,0,0):
 *  unknown with 5; voxel (9,9,9): 2 with 1, now free. */
SemanticVoxelMap smallMap(EntropyMeasure measure = EntropyMeasure::expected, double prior = 0)
{
    MapOptions options;
    options.resolution = RESOLUTION;
    options.entropy = measure;
    options.prior_strength = prior;
    SemanticVoxelMap map(options);
    for (const char* name : {"table", "chair", "sofa", "lamp"}) map.categories().add(name);
    Instance& first = map.createInstance();
    first.categories.add(1, 3);
    first.categories.add(2, 1);
    first.observations = 4;
    Instance& second = map.createInstance();
    second.categories.add(0, 2);
    map.addEvidence({0, 0, 0}, 1, 6);
    map.addEvidence({0, 0, 0}, 2, 3);
    map.addEvidence({0, 0, 0}, UNKNOWN_INSTANCE, 1);
    map.addEvidence({-1, 0, 0}, 1, 2);
    map.addEvidence({4, 0, 0}, UNKNOWN_INSTANCE, 5);
    map.addEvidence({9, 9, 9}, 2, 1);
    for (const VoxelCoord& v : {VoxelCoord{0, 0, 0}, {-1, 0, 0}, {4, 0, 0}})
        map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), 1000);
    map.blocks().at({1, 1, 1}).setOccupancy(cellOf({9, 9, 9}), -1000);
    return map;
}

double harmonic(int n)
{
    double sum = 0;
    for (int i = 1; i <= n; ++i) sum += 1.0 / i;
    return sum;
}
}  // namespace

TEST(MapQueries, CategoryDistributionIsTheMeanMostProbableFirst)
{
    const auto map = smallMap();
    const auto ranked = categoryDistribution(map, map.instance(1));
    ASSERT_EQ(ranked.size(), 2u);
    EXPECT_EQ(ranked[0].name, "chair");
    EXPECT_DOUBLE_EQ(ranked[0].probability, 0.75);
    EXPECT_EQ(ranked[1].name, "sofa");
    EXPECT_DOUBLE_EQ(ranked[1].probability, 0.25);
}

TEST(MapQueries, PriorSpreadsOverAllKnownCategories)
{
    const auto map = smallMap(EntropyMeasure::expected, 2);  // 0.5 each of 4
    const auto ranked = categoryDistribution(map, map.instance(1));
    ASSERT_EQ(ranked.size(), 4u);
    EXPECT_DOUBLE_EQ(ranked[0].probability, 3.5 / 6);
    EXPECT_DOUBLE_EQ(ranked[1].probability, 1.5 / 6);
    EXPECT_EQ(ranked[2].name, "lamp") << "ties go by name";
    EXPECT_DOUBLE_EQ(ranked[3].probability, 0.5 / 6);
    EXPECT_DOUBLE_EQ(categoryVacuity(map, map.instance(1)), 2.0 / 6);
    EXPECT_EQ(categoryVacuity(smallMap(), smallMap().instance(1)), 0);
}

TEST(MapQueries, CategoryEntropyByHand)
{
    const auto of = [](EntropyMeasure m) {
        const auto map = smallMap(m);
        return categoryEntropy(map, map.instance(1));
    };
    const double expected = harmonic(4) - (3 * harmonic(3) + harmonic(1)) / 4;
    EXPECT_NEAR(of(EntropyMeasure::expected), expected, 1e-10);
    EXPECT_NEAR(of(EntropyMeasure::paper), expected + 1. / 4, 1e-10);
    EXPECT_NEAR(of(EntropyMeasure::mean), -(0.75 * std::log(0.75) + 0.25 * std::log(0.25)), 1e-10);
    const auto map = smallMap();
    EXPECT_EQ(categoryEntropy(map, map.instance(2)), 0);
}

TEST(MapQueries, VoxelEntropyAndWinnerByHand)
{
    const auto map = smallMap();
    const VoxelEvidence& shared = *map.evidence({0, 0, 0});
    EXPECT_DOUBLE_EQ(winnerProbability(SemanticVoxelMap(), shared), 0.6);
    EXPECT_NEAR(instanceEntropy(map, shared),
                harmonic(10) - (6 * harmonic(6) + 3 * harmonic(3) + harmonic(1)) / 10, 1e-10);
    EXPECT_EQ(instanceEntropy(map, *map.evidence({-1, 0, 0})), 0);
    EXPECT_EQ(winnerProbability(SemanticVoxelMap(), VoxelEvidence()), 0);
}

TEST(MapQueries, InactiveInstancesCountAsUnknown)
{
    auto map = smallMap();
    const VoxelEvidence& shared = *map.evidence({0, 0, 0});  // 1: 6, 2: 3, unknown: 1
    map.deactivate(1);
    EXPECT_DOUBLE_EQ(winnerProbability(map, shared), 0.3);
    EXPECT_NEAR(instanceEntropy(map, shared),
                harmonic(10) - (7 * harmonic(7) + 3 * harmonic(3)) / 10, 1e-10);
    map.deactivate(2);
    EXPECT_DOUBLE_EQ(winnerProbability(map, shared), 1);
    EXPECT_EQ(instanceEntropy(map, shared), 0);
    EXPECT_DOUBLE_EQ(winnerProbability(map, *map.evidence({-1, 0, 0})), 1);
}

TEST(MapQueries, CategoriesOfAVoxelFollowTotalProbability)
{
    const auto map = smallMap();
    VoxelUncertainty uncertainty(map);
    const auto p = uncertainty.categories(*map.evidence({0, 0, 0}));
    ASSERT_EQ(p.size(), 5u);
    EXPECT_NEAR(p[0], 0.3, 1e-12);         // table: instance 2
    EXPECT_NEAR(p[1], 0.6 * 0.75, 1e-12);  // chair
    EXPECT_NEAR(p[2], 0.6 * 0.25, 1e-12);  // sofa
    EXPECT_EQ(p[3], 0);
    EXPECT_NEAR(p[4], 0.1, 1e-12);  // unknown
    EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1, 1e-12);
    double entropy = 0;
    for (const double x : {0.3, 0.45, 0.15, 0.1}) entropy -= x * std::log(x);
    EXPECT_NEAR(uncertainty.categoryEntropy(*map.evidence({0, 0, 0})), entropy, 1e-12);
    EXPECT_EQ(uncertainty.categories(*map.evidence({4, 0, 0})),
              (std::vector<double>{0, 0, 0, 0, 1}));
}

TEST(MapQueries, UncertaintiesOfAVoxelsWinner)
{
    const auto map = smallMap();
    const VoxelUncertainty uncertainty(map);
    const VoxelEvidence& shared = *map.evidence({0, 0, 0});
    EXPECT_NEAR(uncertainty.winnerCategoryEntropy(shared), categoryEntropy(map, map.instance(1)),
                1e-12);
    EXPECT_NEAR(uncertainty.instanceEntropy(shared), instanceEntropy(map, shared), 1e-12);
    EXPECT_EQ(uncertainty.winnerCategoryEntropy(*map.evidence({4, 0, 0})), 0);
}

TEST(MapQueries, SummariesHoldInstancesThatWinAnOccupiedVoxel)
{
    const auto map = smallMap();
    const auto summaries = summarizeInstances(map);
    ASSERT_EQ(summaries.size(), 1u) << "instance 2 wins a free voxel only";
    const InstanceSummary& s = summaries[0];
    EXPECT_EQ(s.id, 1u);
    EXPECT_EQ(s.category(), "chair");
    EXPECT_DOUBLE_EQ(s.probability(), 0.75);
    EXPECT_EQ(s.voxels, 2u);
    EXPECT_EQ(s.observations, 4u);
    EXPECT_NEAR(s.centroid.x, 0, 1e-12);
    EXPECT_NEAR(s.centroid.y, 0.05, 1e-12);
    EXPECT_NEAR(s.boxMin.x, -0.1, 1e-12);
    EXPECT_NEAR(s.boxMax.x, 0.1, 1e-12);
    EXPECT_NEAR(s.boxMin.z, 0, 1e-12);
    EXPECT_NEAR(s.boxMax.z, 0.1, 1e-12);
    EXPECT_NEAR(s.geometricEntropy, instanceEntropy(map, *map.evidence({0, 0, 0})) / 2, 1e-12);
}

TEST(MapQueries, InstancesWithoutCategoriesAreUnknown)
{
    SemanticVoxelMap map;
    map.createInstance();
    map.addEvidence({0, 0, 0}, 1, 1);
    map.blocks().at({0, 0, 0}).setOccupancy(0, 1000);
    const auto summaries = summarizeInstances(map);
    ASSERT_EQ(summaries.size(), 1u);
    EXPECT_EQ(summaries[0].category(), UNKNOWN_CATEGORY);
    EXPECT_EQ(summaries[0].probability(), 0);
    VoxelUncertainty uncertainty(map);
    EXPECT_EQ(uncertainty.categories(*map.evidence({0, 0, 0})), std::vector<double>{1});
}

TEST(MapQueries, DecisionsAreOpinionsToo)
{
    auto map = smallMap();
    Decision decision;
    decision.category = 2;
    decision.evidence = 4;
    map.instance(1).decisions.push_back(decision);
    const auto ranked = categoryDistribution(map, map.instance(1));
    ASSERT_EQ(ranked.size(), 2u);
    EXPECT_EQ(ranked[0].name, "sofa");
    EXPECT_DOUBLE_EQ(ranked[0].probability, 5.0 / 8);
    const double expected = harmonic(8) - (3 * harmonic(3) + 5 * harmonic(5)) / 8;
    EXPECT_NEAR(categoryEntropy(map, map.instance(1)), expected, 1e-10);
    EXPECT_DOUBLE_EQ(map.instance(1).categories.sum().total(), 4) << "what detectors said stays";
}

TEST(MapQueries, ADecisionForUnknownIsAShareOfUnknown)
{
    auto map = smallMap(EntropyMeasure::expected, 2);  // 0.5 each of 4
    Decision decision;
    decision.evidence = 6;
    map.instance(1).decisions.push_back(decision);
    const auto ranked = categoryDistribution(map, map.instance(1));
    ASSERT_EQ(ranked.size(), 5u);
    EXPECT_EQ(ranked[0].name, UNKNOWN_CATEGORY);
    EXPECT_EQ(ranked[0].category, UNKNOWN_CATEGORY_ID);
    EXPECT_DOUBLE_EQ(ranked[0].probability, 6.0 / 12);
    EXPECT_EQ(summarizeInstances(map)[0].category(), UNKNOWN_CATEGORY);
    VoxelUncertainty uncertainty(map);
    // Instance 1 alone: its share of unknown is that of the voxel.
    EXPECT_DOUBLE_EQ(uncertainty.categories(*map.evidence({-1, 0, 0})).back(), 6.0 / 12);
}
