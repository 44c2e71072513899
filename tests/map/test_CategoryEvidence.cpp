// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/CategoryEvidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace voxeland;

namespace
{
CategoryEvidence evidence(std::initializer_list<std::pair<category_id_t, double>> beta)
{
    CategoryEvidence e;
    for (const auto& [category, b] : beta) e.add(category, b);
    return e;
}
}  // namespace

TEST(CategoryTable, NumbersNamesInOrderOfAppearance)
{
    CategoryTable table;
    EXPECT_EQ(table.add("chair"), 0u);
    EXPECT_EQ(table.add("dining table"), 1u);
    EXPECT_EQ(table.add("chair"), 0u);
    EXPECT_EQ(table.add("Chair"), 2u);
    EXPECT_EQ(table.name(1), "dining table");
    EXPECT_EQ(table.size(), 3u);
    EXPECT_THROW(static_cast<void>(table.name(3)), std::out_of_range);
}

TEST(CategoryEvidence, AddsUpByCategory)
{
    const auto e = evidence({{5, 0.5}, {2, 1}, {5, 0.25}});
    EXPECT_DOUBLE_EQ(e.betaOf(5), 0.75);
    EXPECT_DOUBLE_EQ(e.betaOf(2), 1);
    EXPECT_DOUBLE_EQ(e.betaOf(3), 0);
    EXPECT_DOUBLE_EQ(e.total(), 1.75);
    ASSERT_EQ(e.entries().size(), 2u);
    EXPECT_EQ(e.entries()[0].category, 2u);
    EXPECT_EQ(e.entries()[1].category, 5u);
}

TEST(CategoryEvidence, EntriesThatReachZeroGo)
{
    auto e = evidence({{1, 0.5}, {2, 0.5}});
    e.add(1, -0.5);
    EXPECT_EQ(e.entries().size(), 1u);
    e.add(2, -3);
    EXPECT_TRUE(e.empty());
    e.add(9, -1);
    e.add(9, 0);
    EXPECT_TRUE(e.empty());
}

TEST(CategoryEvidence, AddsAnotherScaled)
{
    auto e = evidence({{1, 1}});
    e.add(evidence({{0, 2}, {1, 4}}), 0.5);
    EXPECT_DOUBLE_EQ(e.betaOf(0), 1);
    EXPECT_DOUBLE_EQ(e.betaOf(1), 3);
}

TEST(CategoryEvidence, WhatIsNoFiniteNumberIsNoEvidence)
{
    auto e = evidence({{1, 0.5}});
    for (const double beta : {std::nan(""), double{INFINITY}, -double{INFINITY}}) {
        e.add(1, beta);
        e.add(2, beta);
    }
    ASSERT_EQ(e.entries().size(), 1U);
    EXPECT_EQ(e.betaOf(1), 0.5);
}

TEST(Sharpened, DoesNotUnderflow)
{
    // (1/4)^100 of the greatest is left of the other one; both powers alone are below any double.
    const auto e = sharpened(evidence({{3, 4e-200}, {5, 1e-200}}), 100);
    EXPECT_NEAR(e.betaOf(3), 1, 1e-12);
    EXPECT_NEAR(e.betaOf(5) / std::pow(0.25, 100), 1, 1e-9);
    EXPECT_TRUE(sharpened({}, 2).empty());
}

TEST(SemanticSimilarity, OfEqualAndDisjointMeans)
{
    EXPECT_DOUBLE_EQ(semanticSimilarity(evidence({{1, 1}, {2, 3}}), evidence({{1, 10}, {2, 30}})),
                     1);
    EXPECT_DOUBLE_EQ(semanticSimilarity(evidence({{1, 1}}), evidence({{2, 1}})), 0);
    EXPECT_DOUBLE_EQ(semanticSimilarity(evidence({{0, 1}, {4, 1}}), evidence({{2, 1}, {7, 3}})), 0);
    EXPECT_EQ(semanticSimilarity({}, evidence({{2, 1}})), 0);
    EXPECT_EQ(semanticSimilarity(evidence({{2, 1}}), {}), 0);
}

TEST(SemanticSimilarity, ByHand)
{
    // Means (1,0) and (1/2,1/2): JSD = 1/2 log2(4/3) + 1/4 log2(2/3) + 1/4.
    const double jsd = 0.5 * std::log2(4. / 3) + 0.25 * std::log2(2. / 3) + 0.25;
    EXPECT_NEAR(semanticSimilarity(evidence({{3, 5}}), evidence({{1, 2}, {3, 2}})), 1 - jsd, 1e-12);
    EXPECT_NEAR(semanticSimilarity(evidence({{1, 2}, {3, 2}}), evidence({{3, 5}})), 1 - jsd, 1e-12);
    // Means (1/2,1/2,0) and (0,1/2,1/2): JSD = 1/2.
    EXPECT_NEAR(semanticSimilarity(evidence({{0, 1}, {1, 1}}), evidence({{1, 1}, {2, 1}})), 0.5,
                1e-12);
}
