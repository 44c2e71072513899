// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/UncertaintyMeasures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace voxeland;
using Decisions = std::vector<UncertainDecision>;

namespace
{
/** Decisions with many equal uncertainties; the wrong ones tend to be the uncertain ones. */
Decisions randomDecisions(std::mt19937& random)
{
    Decisions d;
    for (size_t i = 0, n = random() % 40; i < n; ++i) {
        const bool wrong = random() % 3 == 0;
        d.push_back({static_cast<double>(random() % 8 + (wrong ? 2 : 0)) / 4, wrong});
    }
    return d;
}

double youdenAt(const Decisions& decisions, double threshold)
{
    double right = 0, wrong = 0, rightAbove = 0, wrongAbove = 0;
    for (const auto& d : decisions) {
        (d.wrong ? wrong : right) += 1;
        if (d.uncertainty > threshold) (d.wrong ? wrongAbove : rightAbove) += 1;
    }
    return wrongAbove / wrong - rightAbove / right;
}
}  // namespace

TEST(AreaUnderRoc, equalsTheShareOfOrderedPairs)
{
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        const Decisions decisions = randomDecisions(random);
        double pairs = 0, ordered = 0;
        for (const auto& w : decisions)
            for (const auto& r : decisions) {
                if (!w.wrong || r.wrong) continue;
                ++pairs;
                if (w.uncertainty > r.uncertainty) ordered += 1;
                if (w.uncertainty == r.uncertainty) ordered += 0.5;
            }
        if (pairs == 0)
            EXPECT_TRUE(std::isnan(areaUnderRoc(decisions)));
        else
            EXPECT_NEAR(areaUnderRoc(decisions), ordered / pairs, 1e-12);
    }
}

TEST(AreaUnderRoc, extremes)
{
    EXPECT_EQ(areaUnderRoc({{0.1, false}, {0.2, true}}), 1);
    EXPECT_EQ(areaUnderRoc({{0.1, true}, {0.2, false}}), 0);
    EXPECT_EQ(areaUnderRoc({{0.1, true}, {0.1, false}}), 0.5);
}

TEST(SuggestedThreshold, noThresholdHasALargerYoudenIndex)
{
    std::mt19937 random(6);
    int found = 0;
    for (int round = 0; round < 300; ++round) {
        const Decisions decisions = randomDecisions(random);
        const auto suggested = suggestedThreshold(decisions);
        double best = 0;
        for (double t = -0.125; t < 4; t += 0.25) {
            const double youden = youdenAt(decisions, t);
            if (youden > best) best = youden;
        }
        EXPECT_EQ(suggested.has_value(), best > 0);
        if (!suggested) continue;
        ++found;
        EXPECT_NEAR(suggested->youden, best, 1e-12);
        EXPECT_NEAR(youdenAt(decisions, suggested->value), best, 1e-12);
    }
    EXPECT_GT(found, 100);
}

TEST(SuggestedThreshold, isHalfWayAndDoubtsLeast)
{
    const auto t = suggestedThreshold({{0.2, false}, {0.4, false}, {0.8, true}});
    ASSERT_TRUE(t);
    EXPECT_DOUBLE_EQ(t->value, 0.6);
    EXPECT_EQ(t->youden, 1);
    // above 0.3: 1 - 1/2, above 0.5 (one wrong, one right lower): 1/2 - 0
    const auto equal = suggestedThreshold({{0.2, false}, {0.4, true}, {0.45, false}, {0.6, true}});
    ASSERT_TRUE(equal);
    EXPECT_NEAR(equal->value, 0.525, 1e-12);
    EXPECT_FALSE(suggestedThreshold({{0.2, true}, {0.4, false}}));
    EXPECT_FALSE(suggestedThreshold({{0.2, true}, {0.4, true}}));
    EXPECT_FALSE(suggestedThreshold({}));
}

TEST(ExpectedCalibrationError, worksOutAsByHand)
{
    // (0.8,0.9]: two, mean probability 0.875, accuracy 1/2; (0.9,1]: two, 0.975, accuracy 1;
    // (0.3,0.4]: one, 0.4, wrong
    const std::vector<ConfidentDecision> d = {
        {0.85, true}, {0.9, false}, {0.95, true}, {1.0, true}, {0.4, false}};
    EXPECT_NEAR(expectedCalibrationError(d), (2 * 0.375 + 2 * 0.025 + 0.4) / 5, 1e-12);
    EXPECT_NEAR(expectedCalibrationError({{0, false}, {1, true}}), 0, 1e-12);
    EXPECT_TRUE(std::isnan(expectedCalibrationError({})));
}

TEST(CalibrationError, ofEqualMassHasAsManyDecisionsInEachBin)
{
    // Two bins of two: {0.1 wrong, 0.2 right} lack 0.7, {0.8 right, 0.9 wrong} have 0.7 too much.
    const std::vector<ConfidentDecision> d = {{0.9, false}, {0.2, true}, {0.8, true}, {0.1, false}};
    EXPECT_NEAR(equalMassCalibrationError(d, 2), (0.7 + 0.7) / 4, 1e-12);
    EXPECT_NEAR(equalMassCalibrationError(d, 1), 0, 1e-12);
    EXPECT_NEAR(equalMassCalibrationError(d, 10), (0.1 + 0.8 + 0.2 + 0.9) / 4, 1e-12);
    EXPECT_TRUE(std::isnan(equalMassCalibrationError({})));
}

TEST(CalibrationError, byChanceIsThatOfDrawsFromTheProbabilities)
{
    // One bin of n decisions of p: the mean of |B / n - p|, B binomial. For n = 1 that is 2 p (1 -
    // p).
    EXPECT_NEAR(calibrationErrorByChance({{0.5, true}}, 1), 0.5, 1e-12);
    EXPECT_NEAR(calibrationErrorByChance({{0.9, false}}, 1), 0.18, 0.06);
    const std::vector<ConfidentDecision> many(2500, {0.5, false});
    EXPECT_NEAR(calibrationErrorByChance(many, 1), std::sqrt(2 / M_PI) * 0.5 / 50, 0.0012);
    EXPECT_TRUE(std::isnan(calibrationErrorByChance({})));
}

TEST(Reliability, binsAreOfEquallyManyInOrder)
{
    const auto diagram = reliability({{0.9, false}, {0.2, true}, {0.8, true}, {0.1, false}}, 2);
    ASSERT_EQ(diagram.size(), 2U);
    EXPECT_EQ(diagram[0].decisions, 2U);
    EXPECT_NEAR(diagram[0].probability, 0.15, 1e-12);
    EXPECT_EQ(diagram[0].correct, 0.5);
    EXPECT_NEAR(diagram[1].probability, 0.85, 1e-12);
    EXPECT_TRUE(reliability({}).empty());
}

TEST(BrierScore, isTheMeanSquareOfWhatWasMissing)
{
    EXPECT_NEAR(brierScore({{0.9, true}, {0.5, false}, {0.2, false}}), (0.01 + 0.25 + 0.04) / 3,
                1e-12);
    EXPECT_TRUE(std::isnan(brierScore({})));
}

TEST(NegativeLogLikelihood, isTheMeanSurpriseAndFinite)
{
    EXPECT_NEAR(negativeLogLikelihood({{0.5, true}, {0.75, false}}),
                (std::log(2) + std::log(4)) / 2, 1e-12);
    EXPECT_NEAR(negativeLogLikelihood({{1, false}}), std::log(1e6), 1e-6);
    EXPECT_TRUE(std::isnan(negativeLogLikelihood({})));
}

TEST(PrecisionCurve, countsInstancesBelowEachThreshold)
{
    const auto curve = precisionCurve({{0.0, false}, {0.25, true}, {0.6, false}}, 0.25);
    ASSERT_EQ(curve.size(), 3U);
    EXPECT_EQ(curve[0].threshold, 0.25);
    EXPECT_EQ(curve[0].instances, 1U) << "below, not at the threshold";
    EXPECT_EQ(curve[0].precision(), 1);
    EXPECT_EQ(curve[1].precision(), 0.5);
    EXPECT_EQ(curve[2].threshold, 0.75);
    EXPECT_DOUBLE_EQ(curve[2].precision(), 2.0 / 3);
    EXPECT_TRUE(precisionCurve({}).empty());
    EXPECT_TRUE(std::isnan(precisionCurve({{0.3, true}})[0].precision()));
}
