// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using voxeland::simulation::Random;

namespace
{
constexpr int N = 100000;
}

TEST(Random, SameSeedSameNumbersOtherSeedOrStreamOrIndexOthers)
{
    Random a(1, 2, 3), same(1, 2, 3);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(a.uniform(), same.uniform());
    const double first = Random(1, 2, 3).uniform();
    EXPECT_NE(first, Random(2, 2, 3).uniform());
    EXPECT_NE(first, Random(1, 3, 3).uniform());
    EXPECT_NE(first, Random(1, 2, 4).uniform());
}

TEST(Random, NormalHasItsMomentsAndTails)
{
    Random random(1);
    double sum = 0, squares = 0;
    int beyondTwo = 0;
    for (int i = 0; i < N; ++i) {
        const double x = static_cast<double>(random.normal(2));
        sum += x;
        squares += x * x;
        beyondTwo += std::abs(x) > 4 ? 1 : 0;
    }
    EXPECT_NEAR(sum / N, 0, 5 * 2 / std::sqrt(N));
    EXPECT_NEAR(std::sqrt(squares / N), 2, 5 * 2 / std::sqrt(2.0 * N));
    EXPECT_NEAR(beyondTwo / double(N), 0.0455, 5 * std::sqrt(0.0455 / N));
}

TEST(Random, BelowIsUniformAndPoissonHasItsMeanAndVariance)
{
    Random random(2);
    std::array<int, 5> counts{};
    double sum = 0, squares = 0;
    for (int i = 0; i < N; ++i) {
        ++counts.at(static_cast<size_t>(random.below(5)));
        const double n = random.poisson(0.7);
        sum += n;
        squares += n * n;
    }
    for (const int count : counts) EXPECT_NEAR(count / double(N), 0.2, 5 * std::sqrt(0.16 / N));
    const double mean = sum / N;
    EXPECT_NEAR(mean, 0.7, 5 * std::sqrt(0.7 / N));
    EXPECT_NEAR(squares / N - mean * mean, 0.7, 0.03);
}
