// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/CategoryOpinions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace voxeland;

namespace
{
CategoryEvidence of(category_id_t category, double beta)
{
    CategoryEvidence evidence;
    evidence.add(category, beta);
    return evidence;
}

void expectSame(const CategoryEvidence& a, const CategoryEvidence& b)
{
    ASSERT_EQ(a.entries().size(), b.entries().size());
    for (size_t i = 0; i < a.entries().size(); ++i) {
        EXPECT_EQ(a.entries()[i].category, b.entries()[i].category);
        EXPECT_NEAR(a.entries()[i].beta, b.entries()[i].beta, 1e-12 * b.entries()[i].beta);
    }
}

/** The number of independent opinions whose mean has the variance of n with unit variance and any
 * two correlated by r: n^2 over the sum of all entries of their covariance. */
double independentOnes(int n, double r)
{
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += i == j ? 1 : r;
    return n * n / sum;
}
}  // namespace

TEST(CategoryOpinions, OfOneSideAreWorthAsManyIndependentOnesAsTheirMeanHasTheVarianceOf)
{
    for (const int n : {1, 2, 3, 10, 1000}) {
        CategoryOpinions opinions;
        for (int i = 0; i < n; ++i) opinions.add(of(3, 0.6), side_t{7});
        const double worth = independentOnes(n, 0.5);
        EXPECT_NEAR(opinions.independent().total(), 0.6 * worth, 1e-9) << n;
        EXPECT_NEAR(opinions.sum().total(), 0.6 * n, 1e-9);
    }
}

TEST(CategoryOpinions, OfDifferentSidesOrOfNoneCountFully)
{
    CategoryOpinions opinions;
    for (side_t side = 0; side < 5; ++side) opinions.add(of(1, 0.5), side);
    for (int i = 0; i < 4; ++i) opinions.add(of(2, 0.25));
    opinions.add(2, 0.5);
    EXPECT_NEAR(opinions.independent().betaOf(1), 2.5, 1e-12);
    EXPECT_NEAR(opinions.independent().betaOf(2), 1.5, 1e-12);
}

TEST(CategoryOpinions, OneSideCannotOutvoteManyHoweverOftenItIsSeen)
{
    CategoryOpinions opinions;
    for (int i = 0; i < 100000; ++i) opinions.add(of(1, 1), side_t{0});
    for (side_t side = 1; side <= 3; ++side) opinions.add(of(2, 1), side);
    EXPECT_LT(opinions.independent().betaOf(1), 2);
    EXPECT_EQ(opinions.independent().top(), category_id_t{2});
    EXPECT_EQ(opinions.sum().top(), category_id_t{1});
}

TEST(CategoryOpinions, NeitherOrderNorMergingMatters)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<int> side(0, 8), category(0, 3);
    std::uniform_real_distribution<double> confidence(0.01, 1);
    std::vector<std::pair<side_t, CategoryEvidence>> all;
    for (int i = 0; i < 200; ++i)
        all.emplace_back(static_cast<side_t>(side(random)),
                         of(static_cast<category_id_t>(category(random)), confidence(random)));
    CategoryOpinions straight, first, second;
    for (const auto& [from, evidence] : all) straight.add(evidence, from);
    std::shuffle(all.begin(), all.end(), random);
    for (size_t i = 0; i < all.size(); ++i)
        (i < 70 ? first : second).add(all[i].second, all[i].first);
    first.add(second);
    expectSame(first.independent(), straight.independent());
    expectSame(first.sum(), straight.sum());
}

TEST(CategoryOpinions, WhatIsTakenAndWhatIsLeftAreAll)
{
    CategoryOpinions opinions;
    for (int i = 0; i < 8; ++i) opinions.add(of(1, 0.5), side_t{4});
    opinions.add(of(2, 3.0));
    const CategoryEvidence before = opinions.independent();
    const CategoryOpinions part = opinions.take(0.25);
    EXPECT_NEAR(part.sum().betaOf(1), 1, 1e-12);
    EXPECT_NEAR(part.sum().betaOf(2), 0.75, 1e-12);
    EXPECT_NEAR(part.bySide().at(0).opinions, 2, 1e-12);
    EXPECT_NEAR(opinions.bySide().at(0).opinions, 6, 1e-12);
    opinions.add(part);
    expectSame(opinions.independent(), before);
    EXPECT_TRUE(opinions.take(0).independent().empty());
    opinions.take(1);
    EXPECT_TRUE(opinions.independent().empty());
    EXPECT_TRUE(opinions.bySide().empty());
}

TEST(CategoryOpinions, WhatNoMappingGivesIsNotRestored)
{
    const auto restored = [](std::vector<CategoryOpinions::OfSide> sides) {
        return CategoryOpinions::restored({}, {}, std::move(sides));
    };
    EXPECT_EQ(restored({{3, 1, {}}, {4, 2, {}}}).bySide().size(), 2U);
    EXPECT_THROW(restored({{3, 1, {}}, {3, 2, {}}}), std::invalid_argument) << "twice";
    EXPECT_THROW(restored({{4, 1, {}}, {3, 2, {}}}), std::invalid_argument) << "not in order";
    EXPECT_THROW(restored({{SIDES, 1, {}}}), std::invalid_argument) << "no side";
    EXPECT_THROW(restored({{3, 0, {}}}), std::invalid_argument) << "no opinions";
    EXPECT_THROW(restored({{3, std::nan(""), {}}}), std::invalid_argument);
    EXPECT_THROW(restored({{3, INFINITY, {}}}), std::invalid_argument);
}
