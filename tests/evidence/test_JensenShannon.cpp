// SPDX-License-Identifier: BSD-3-Clause
#include "evidence/JensenShannon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace voxeland;

namespace
{
std::vector<double> randomDistribution(std::mt19937& random, size_t n)
{
    std::exponential_distribution<double> any(1);
    std::vector<double> p(n);
    double sum = 0;
    for (double& x : p) sum += x = any(random);
    for (double& x : p) x /= sum;
    return p;
}

/** Entropy in bits. */
double entropy(const std::vector<double>& p)
{
    double h = 0;
    for (const double x : p)
        if (x > 0) h -= x * std::log2(x);
    return h;
}
}  // namespace

TEST(JensenShannon, HandValues)
{
    EXPECT_DOUBLE_EQ(jensenShannonDivergence({0.5, 0.5}, {0.5, 0.5}), 0);
    EXPECT_DOUBLE_EQ(jensenShannonDivergence({1, 0}, {0, 1}), 1);
    // m = (3/4, 1/4): 1/2 log2(4/3) + 1/4 log2(2/3) + 1/4 log2(2)
    EXPECT_NEAR(jensenShannonDivergence({1, 0}, {0.5, 0.5}),
                0.5 * std::log2(4. / 3) + 0.25 * std::log2(2. / 3) + 0.25, 1e-12);
    EXPECT_NEAR(jensenShannonDivergence({1, 0}, {0.5, 0.5}), 0.311278124459, 1e-10);
}

TEST(JensenShannon, IsTheEntropyOfTheMixtureLessTheMeanEntropy)
{
    std::mt19937 random(13);
    for (size_t n = 2; n < 40; ++n) {
        const auto p = randomDistribution(random, n), q = randomDistribution(random, n);
        std::vector<double> m(n);
        for (size_t i = 0; i < n; ++i) m[i] = (p[i] + q[i]) / 2;
        EXPECT_NEAR(jensenShannonDivergence(p, q), entropy(m) - (entropy(p) + entropy(q)) / 2,
                    1e-12);
    }
}

TEST(JensenShannon, IsSymmetricAndWithinItsBounds)
{
    std::mt19937 random(14);
    for (int i = 0; i < 200; ++i) {
        auto p = randomDistribution(random, 5), q = randomDistribution(random, 5);
        if (i % 3 == 0) {  // no common outcome
            p.insert(p.end(), 5, 0.0);
            q.insert(q.begin(), 5, 0.0);
        }
        const double d = jensenShannonDivergence(p, q);
        EXPECT_NEAR(d, jensenShannonDivergence(q, p), 1e-15);
        EXPECT_GE(d, 0);
        EXPECT_LE(d, 1);
        EXPECT_NEAR(jensenShannonDivergence(p, p), 0, 1e-15);
        if (i % 3 == 0) {
            EXPECT_NEAR(d, 1, 1e-12);
        }
    }
}

TEST(JensenShannon, RefusesWhatAreNoDistributions)
{
    EXPECT_THROW(jensenShannonDivergence({1}, {0.5, 0.5}), std::invalid_argument);
    EXPECT_THROW(jensenShannonDivergence({0.5, 0.4}, {0.5, 0.5}), std::invalid_argument);
    EXPECT_THROW(jensenShannonDivergence({0.5, 0.5}, {0.5, 0.6}), std::invalid_argument);
    EXPECT_THROW(jensenShannonDivergence({NAN, 1}, {0.5, 0.5}), std::invalid_argument);
}
