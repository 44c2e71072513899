// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evidence/OccupancyFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace voxeland;

namespace
{
constexpr double STEP = 1.0 / 2048;  // of the stored log-odds [nat]

double logOdds(double p)
{
    return std::log(p / (1 - p));
}
}  // namespace

TEST(OccupancyFilter, FollowsTheBayesFilterInDoublePrecision)
{
    const OccupancyFilter::Options o;
    const OccupancyFilter filter(o);
    std::mt19937 random(15);
    for (int run = 0; run < 50; ++run) {
        log_odds_t value = UNOBSERVED;
        double exact = 0;
        // Each update is rounded to half a step at most; clamping never enlarges the difference.
        for (int n = 1; n <= 200; ++n) {
            const bool hit = std::bernoulli_distribution(0.4)(random);
            value = hit ? filter.afterHit(value) : filter.afterMiss(value);
            exact += logOdds(hit ? o.prob_hit : o.prob_miss);
            exact = std::clamp(exact, logOdds(o.prob_min), logOdds(o.prob_max));
            ASSERT_NEAR(logOdds(OccupancyFilter::probability(value)), exact,
                        (n + 1) * STEP / 2 + 1e-9);
        }
    }
}

TEST(OccupancyFilter, OneHitAndOneMissGiveTheSensorModel)
{
    const OccupancyFilter filter;
    EXPECT_NEAR(OccupancyFilter::probability(filter.afterHit(UNOBSERVED)), 0.7, 1e-3);
    EXPECT_NEAR(OccupancyFilter::probability(filter.afterMiss(UNOBSERVED)), 0.4, 1e-3);
    EXPECT_NEAR(OccupancyFilter::probability(filter.afterHit(filter.afterMiss(UNOBSERVED))),
                0.7 * 0.4 / (0.7 * 0.4 + 0.3 * 0.6), 1e-3);
}

TEST(OccupancyFilter, ClampsAndCanChangeItsMind)
{
    const OccupancyFilter filter;
    log_odds_t value = UNOBSERVED;
    for (int i = 0; i < 1000; ++i) value = filter.afterHit(value);
    EXPECT_NEAR(OccupancyFilter::probability(value), 0.97, 1e-4);
    int misses = 0;
    for (; OccupancyFilter::isOccupied(value); ++misses) value = filter.afterMiss(value);
    EXPECT_EQ(misses, 9);  // ln(0.97/0.03) / ln(0.6/0.4) = 8.57
    for (int i = 0; i < 1000; ++i) value = filter.afterMiss(value);
    EXPECT_NEAR(OccupancyFilter::probability(value), 0.12, 1e-4);
}

TEST(OccupancyFilter, UnobservedIsNeitherOccupiedNorFree)
{
    EXPECT_EQ(OccupancyFilter::probability(UNOBSERVED), 0.5);
    EXPECT_FALSE(OccupancyFilter::isOccupied(UNOBSERVED));
    EXPECT_FALSE(OccupancyFilter::isOccupied(0));
    EXPECT_TRUE(OccupancyFilter::isOccupied(1));
    EXPECT_EQ(OccupancyFilter::probability(0), 0.5);
}

TEST(OccupancyFilter, ProbabilitiesReadBack)
{
    for (double p = 0.001; p < 1; p += 0.001)
        EXPECT_NEAR(OccupancyFilter::probability(OccupancyFilter::fromProbability(p)), p,
                    STEP / 2 * p * (1 - p) + 1e-7);
    EXPECT_THROW(OccupancyFilter::fromProbability(0), std::invalid_argument);
    EXPECT_THROW(OccupancyFilter::fromProbability(1), std::invalid_argument);
    EXPECT_THROW(OccupancyFilter::fromProbability(NAN), std::invalid_argument);
}

TEST(OccupancyFilter, RefusesOptionsThatMakeNoFilter)
{
    const auto make = [](double hit, double miss, double least, double most) {
        OccupancyFilter({hit, miss, least, most});
    };
    EXPECT_NO_THROW(make(0.7, 0.4, 0.12, 0.97));
    EXPECT_NO_THROW(make(0.7, 0.4, 0.4, 0.7));
    EXPECT_THROW(make(0.5, 0.4, 0.12, 0.97), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.5, 0.12, 0.97), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.4, 0.45, 0.97), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.4, 0.12, 0.6), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.4, 0, 0.97), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.4, 0.12, 1), std::invalid_argument);
    EXPECT_THROW(make(NAN, 0.4, 0.12, 0.97), std::invalid_argument);
    EXPECT_THROW(make(0.7, 0.4, 1e-9, 0.97), std::invalid_argument);
}

TEST(OccupancyFilter, WeakenedObservationsAddAShareOfTheLogOdds)
{
    const OccupancyFilter filter;
    const OccupancyFilter third = filter.weakened(1.0 / 3);
    log_odds_t hits = UNOBSERVED, misses = UNOBSERVED;
    for (int i = 0; i < 3; ++i) {
        hits = third.afterHit(hits);
        misses = third.afterMiss(misses);
    }
    EXPECT_NEAR(OccupancyFilter::probability(hits), 0.7, 1e-3);
    EXPECT_NEAR(OccupancyFilter::probability(misses), 0.4, 1e-3);
    for (int i = 0; i < 1000; ++i) hits = third.afterHit(hits);
    EXPECT_NEAR(OccupancyFilter::probability(hits), 0.97, 1e-3) << "the limits stay";
    EXPECT_EQ(filter.weakened(1).afterHit(100), filter.afterHit(100));
    EXPECT_EQ(filter.weakened(0).afterMiss(100), 100);
}

TEST(OccupancyFilter, EvenOddsAreNeitherOccupiedNorFree)
{
    EXPECT_TRUE(OccupancyFilter::isOccupied(1));
    EXPECT_TRUE(OccupancyFilter::isFree(-1));
    for (const log_odds_t even : {log_odds_t{0}, UNOBSERVED}) {
        EXPECT_FALSE(OccupancyFilter::isOccupied(even));
        EXPECT_FALSE(OccupancyFilter::isFree(even));
    }
}
