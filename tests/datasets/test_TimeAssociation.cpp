// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/TimeAssociation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

using voxeland::associateTimes;

namespace
{
using Times = std::vector<double>;
using Partners = std::vector<int64_t>;

/** As the definition says, by way of all pairs. */
Partners ofAllPairs(const Times& first, const Times& second, double apart)
{
    std::vector<std::tuple<double, size_t, size_t>> pairs;
    for (size_t i = 0; i < first.size(); ++i)
        for (size_t j = 0; j < second.size(); ++j)
            if (std::abs(first[i] - second[j]) <= apart)
                pairs.emplace_back(std::abs(first[i] - second[j]), i, j);
    std::sort(pairs.begin(), pairs.end());
    Partners partners(first.size(), -1);
    std::vector<bool> taken(second.size(), false);
    for (const auto& [by, i, j] : pairs) {
        if (partners[i] >= 0 || taken[j]) continue;
        partners[i] = static_cast<int64_t>(j);
        taken[j] = true;
    }
    return partners;
}
}  // namespace

TEST(TimeAssociation, PairsTheClosest)
{
    EXPECT_EQ(associateTimes({1, 2, 3}, {2.25, 0.875}, 0.5), (Partners{1, 0, -1}));
    EXPECT_EQ(associateTimes({1}, {1.5}, 0.25), Partners{-1});
    EXPECT_EQ(associateTimes({1, 1.25}, {1.25}, 1), (Partners{-1, 0}));
    EXPECT_EQ(associateTimes({}, {1}, 1), Partners{});
}

TEST(TimeAssociation, OfEquallyCloseTheEarlierPlaces)
{
    EXPECT_EQ(associateTimes({1, 3}, {2}, 1), (Partners{0, -1}));
    EXPECT_EQ(associateTimes({3, 1}, {2}, 1), (Partners{0, -1}));
    EXPECT_EQ(associateTimes({2, 2, 2}, {2, 2}, 1), (Partners{0, 1, -1}));
}

TEST(TimeAssociation, IsThatOfAllPairs)
{
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        // Times that repeat, and are equally close, in any order; in binary they are exact.
        std::uniform_int_distribution<int> time(0, 1 + round % 60);
        Times first(static_cast<size_t>(round % 23)), second(static_cast<size_t>(round % 19));
        for (Times* times : {&first, &second})
            for (double& t : *times) t = time(random) / 8.0;
        EXPECT_EQ(associateTimes(first, second, 0.5), ofAllPairs(first, second, 0.5)) << round;
    }
}

TEST(TimeAssociation, ManyOfOneTimeAreNoMoreWork)
{
    // All pairs of these would be 10^10, of 24 bytes each.
    const size_t count = 100000;
    const Partners partners = associateTimes(Times(count, 5.0), Times(count, 5.015625), 0.02);
    for (size_t i = 0; i < count; ++i) ASSERT_EQ(partners[i], static_cast<int64_t>(i));
}
