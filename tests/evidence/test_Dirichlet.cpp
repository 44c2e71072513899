// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evidence/Dirichlet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace voxeland;

namespace
{
constexpr double EULER = 0.57721566490153286;

/** Mean and its standard error of the Shannon entropy of samples of a Dirichlet distribution. */
std::pair<double, double> sampledEntropy(const std::vector<double>& concentration, int samples)
{
    std::mt19937_64 random(11);
    double sum = 0, squares = 0;
    for (int s = 0; s < samples; ++s) {
        std::vector<double> p;
        double total = 0;
        for (const double a : concentration) {
            p.push_back(std::gamma_distribution<double>(a, 1)(random));
            total += p.back();
        }
        double entropy = 0;
        for (const double x : p)
            if (x > 0) entropy -= x / total * std::log(x / total);
        sum += entropy;
        squares += entropy * entropy;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt((squares / samples - mean * mean) / samples)};
}
}  // namespace

TEST(Digamma, KnownValues)
{
    EXPECT_NEAR(digamma(1), -EULER, 1e-10);
    EXPECT_NEAR(digamma(0.5), -1.96351002602142348, 1e-10);
    EXPECT_NEAR(digamma(2), 1 - EULER, 1e-10);
    EXPECT_NEAR(digamma(0.25), -EULER - M_PI / 2 - 3 * std::log(2.0), 1e-10);
    EXPECT_NEAR(digamma(1. / 3), -EULER - M_PI / (2 * std::sqrt(3.0)) - 1.5 * std::log(3.0), 1e-10);
    EXPECT_NEAR(digamma(10), 2.25175258906672111, 1e-10);
    EXPECT_NEAR(digamma(1e6), std::log(1e6) - 0.5e-6, 1e-10);
}

TEST(Digamma, OfWholeNumbersIsAHarmonicSum)
{
    double harmonic = 0;
    for (int n = 1; n < 60; ++n) {
        EXPECT_NEAR(digamma(n), harmonic - EULER, 1e-10) << n;
        harmonic += 1.0 / n;
    }
}

TEST(Digamma, Recurrence)
{
    for (double x = 0.01; x < 30; x += 0.0937)
        EXPECT_NEAR(digamma(x + 1), digamma(x) + 1 / x, 1e-10) << x;
}

TEST(Digamma, IsTheDerivativeOfLogGamma)
{
    for (const double x : {0.3, 1.7, 4.2, 9.99, 10.01, 25.0}) {
        constexpr double H = 1e-4;
        const double slope = (std::lgamma(x + H) - std::lgamma(x - H)) / (2 * H);
        EXPECT_NEAR(digamma(x), slope, 1e-6 / x) << x;
    }
}

TEST(DirichletEntropy, CheckValuesOfTheDesign)
{
    const auto entropy = [](double a, double b, EntropyMeasure m) {
        return dirichletEntropy({a, b}, m);
    };
    EXPECT_NEAR(entropy(1, 1, EntropyMeasure::paper), 1.0, 5e-5);
    EXPECT_NEAR(entropy(1, 1, EntropyMeasure::expected), 0.5, 5e-5);
    EXPECT_NEAR(entropy(1, 1, EntropyMeasure::mean), 0.6931, 5e-5);
    EXPECT_NEAR(entropy(10, 1, EntropyMeasure::paper), 0.3572, 5e-5);
    EXPECT_NEAR(entropy(10, 1, EntropyMeasure::expected), 0.2663, 5e-5);
    EXPECT_NEAR(entropy(10, 1, EntropyMeasure::mean), 0.3046, 5e-5);
    EXPECT_NEAR(entropy(2, 2, EntropyMeasure::paper), 0.8333, 5e-5);
    EXPECT_NEAR(entropy(2, 2, EntropyMeasure::expected), 0.5833, 5e-5);
    EXPECT_NEAR(entropy(2, 2, EntropyMeasure::mean), 0.6931, 5e-5);
}

TEST(DirichletEntropy, OfWholeNumbersByHarmonicSums)
{
    // psi(n+1) = H_n - gamma; for (3,2,1): H_6 - (3 H_3 + 2 H_2 + 1 H_1) / 6.
    const double expected = 2.45 - (3 * (11. / 6) + 2 * 1.5 + 1) / 6;
    EXPECT_NEAR(dirichletEntropy({3, 2, 1}, EntropyMeasure::expected), expected, 1e-10);
}

TEST(DirichletEntropy, ExpectedAgreesWithSampling)
{
    for (const auto& a : std::vector<std::vector<double>>{
             {1, 1}, {0.4, 2.5}, {3, 2, 1}, {0.2, 0.2, 0.2, 5}, {20, 10, 1, 1, 0.5}})
    {
        const auto [mean, error] = sampledEntropy(a, 200000);
        EXPECT_NEAR(dirichletEntropy(a, EntropyMeasure::expected), mean, 4 * error);
    }
}

TEST(DirichletEntropy, PaperExceedsExpectedByKMinusOneOverA)
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> any(0.05, 20);
    for (size_t k = 2; k < 12; ++k) {
        std::vector<double> a(k);
        double total = 0;
        for (double& x : a) total += x = any(random);
        EXPECT_NEAR(dirichletEntropy(a, EntropyMeasure::paper) -
                        dirichletEntropy(a, EntropyMeasure::expected),
                    static_cast<double>(k - 1) / total, 1e-9);
    }
}

TEST(DirichletEntropy, MeanIsTheShannonEntropyOfTheMean)
{
    EXPECT_NEAR(dirichletEntropy({6, 3, 1}, EntropyMeasure::mean),
                -(0.6 * std::log(0.6) + 0.3 * std::log(0.3) + 0.1 * std::log(0.1)), 1e-12);
    EXPECT_NEAR(shannonEntropy({0.6, 0.3, 0.1, 0}),
                -(0.6 * std::log(0.6) + 0.3 * std::log(0.3) + 0.1 * std::log(0.1)), 1e-12);
    EXPECT_NEAR(shannonEntropy({0.25, 0.25, 0.25, 0.25}), std::log(4), 1e-12);
    EXPECT_EQ(shannonEntropy({1}), 0);
}

TEST(DirichletEntropy, ParametersThatAreZeroTakeNoPart)
{
    for (const auto m : {EntropyMeasure::expected, EntropyMeasure::paper, EntropyMeasure::mean}) {
        EXPECT_DOUBLE_EQ(dirichletEntropy({0, 2, 0, 5, 0}, m), dirichletEntropy({2, 5}, m));
        EXPECT_EQ(dirichletEntropy({}, m), 0);
        EXPECT_EQ(dirichletEntropy({0, 0}, m), 0);
        EXPECT_EQ(dirichletEntropy({7}, m), 0);
    }
}

TEST(DirichletEntropy, ExpectedAndMeanConvergeWithEvidence)
{
    EXPECT_NEAR(dirichletEntropy({7e5, 3e5}, EntropyMeasure::expected),
                dirichletEntropy({7e5, 3e5}, EntropyMeasure::mean), 1e-5);
}

TEST(EntropyMeasure, NamesReadBack)
{
    for (const auto m : {EntropyMeasure::expected, EntropyMeasure::paper, EntropyMeasure::mean})
        EXPECT_EQ(entropyMeasureFromString(toString(m)), m);
    EXPECT_THROW(entropyMeasureFromString("Expected"), std::invalid_argument);
    EXPECT_THROW(entropyMeasureFromString(""), std::invalid_argument);
}

TEST(Vacuity, IsTheShareOfThePrior)
{
    EXPECT_DOUBLE_EQ(vacuity(2, 6), 0.25);
    EXPECT_DOUBLE_EQ(vacuity(2, 0), 1);
    EXPECT_DOUBLE_EQ(vacuity(0, 3), 0);
    EXPECT_DOUBLE_EQ(vacuity(0, 0), 1);
}
