// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/errors.h"
#include "voxeland/evaluation/CalibrationLearning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace voxeland;

namespace
{
using Samples = std::vector<CalibrationSample>;

void add(Samples& samples, int times, const std::map<std::string, double>& words,
         const std::string& truth)
{
    for (int i = 0; i < times; ++i) samples.push_back({words, truth});
}

/** Instances of a detector that calls three things "tv" and is right in seven of ten cases. */
Samples drawn(size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::discrete_distribution<int> truth({70, 20, 10});
    const char* const names[] = {"tv", "laptop", "unknown"};
    Samples samples;
    while (samples.size() < count) {
        samples.push_back({{{"tv", 1}}, names[truth(random)]});
        samples.push_back({{{"laptop", 2}}, "laptop"});
    }
    return samples;
}

/** Mean of -ln of the probability of the truth. */
double lossOf(const Calibration& calibration, const Samples& samples)
{
    double loss = 0;
    for (const CalibrationSample& s : samples) {
        CategoryTable table;
        CategoryEvidence said;
        for (const auto& [word, beta] : s.words) said.add(table.add(word), beta);
        table.add("tv");
        table.add("laptop");
        const CategoryEvidence meant = calibration.applied(said, table);
        const double p = meant.betaOf(table.find(s.truth).value_or(UNKNOWN_CATEGORY_ID));
        loss -= std::log(std::max(p / meant.total(), 1e-6));
    }
    return loss / static_cast<double>(samples.size());
}
}  // namespace

TEST(CalibrationLearning, AWordIsCountedBesideAPriorOfFiveInstances)
{
    Samples a, b;
    add(a, 4, {{"chair", 3}}, "chair");
    add(a, 1, {{"chair", 3}}, "unknown");
    add(b, 4, {{"chair", 1}}, "chair");
    add(b, 1, {{"chair", 1}}, "unknown");
    const Calibration::Meaning meaning = learnCalibration({a, b}).meanings().at("chair");
    // 8 of 10 are right: a word is itself in 10/13 of cases, and unknown in 3/13 * 4/6 of them;
    // the rest would be other words, of which there are none.
    const double chair = 8 + 5 * 10.0 / 13, unknown = 2 + 5 * 2.0 / 13;
    EXPECT_NEAR(meaning.at("chair"), chair / (chair + unknown), 1e-12);
    EXPECT_NEAR(meaning.at("unknown"), unknown / (chair + unknown), 1e-12);
}

TEST(CalibrationLearning, AnInstanceCountsForItsWordsByTheirShare)
{
    Samples samples;
    add(samples, 20, {{"tv", 3}, {"laptop", 1}}, "tv");
    const auto meanings = learnCalibration({samples, samples}).meanings();
    // laptop: 40 instances for a quarter each, all of them tv.
    const double all = 40, right = (30.0 + 2) / (all + 3),
                 unknown = (1 - right) * (0 + 2) / (10 + 4.0);
    EXPECT_NEAR(meanings.at("laptop").at("laptop"), 5 * right / 15, 1e-12);
    EXPECT_NEAR(meanings.at("laptop").at("unknown"), 5 * unknown / 15, 1e-12);
    EXPECT_NEAR(meanings.at("laptop").at("tv"), (5 * (1 - right - unknown) + 10) / 15, 1e-12);
}

TEST(CalibrationLearning, FindsWhatTheDetectorDoes)
{
    const Calibration learnt = learnCalibration({drawn(3000, 1), drawn(3000, 2)});
    const Calibration::Meaning& tv = learnt.meanings().at("tv");
    EXPECT_NEAR(tv.at("tv"), 0.7, 0.03);
    EXPECT_NEAR(tv.at("laptop"), 0.2, 0.03);
    EXPECT_NEAR(tv.at("unknown"), 0.1, 0.03);
    EXPECT_GT(learnt.meanings().at("laptop").at("laptop"), 0.98);
}

TEST(CalibrationLearning, TenInstancesDoNoHarm)
{
    const Samples many = drawn(4000, 99);
    for (unsigned seed = 0; seed < 20; ++seed)
        EXPECT_LT(lossOf(learnCalibration({drawn(5, seed), drawn(5, 100 + seed)}), many),
                  lossOf(Calibration(), many))
            << seed;
}

TEST(CalibrationLearning, WordsThatAgreeAreBelievedAsFarAsTheyAreRight)
{
    Samples sure, unsure;
    for (const auto& [word, other] :
         {std::pair<std::string, std::string>{"tv", "laptop"}, {"laptop", "tv"}})
    {
        add(sure, 200, {{word, 3}, {other, 2}}, word);
        add(unsure, 120, {{word, 1}}, word);
        add(unsure, 80, {{word, 1}}, other);
    }
    EXPECT_EQ(learnCalibration({sure, sure}).agreement(), 4);
    EXPECT_LT(learnCalibration({unsure, unsure}).agreement(), 1.5);
}

TEST(CalibrationLearning, OfASingleMapPartsAreLeftOut)
{
    EXPECT_NEAR(learnCalibration({drawn(2000, 3)}).meanings().at("tv").at("tv"), 0.7, 0.05);
}

TEST(CalibrationLearning, TooFewInstancesAreRefused)
{
    Samples few;
    add(few, 9, {{"tv", 1}}, "tv");
    EXPECT_THROW(learnCalibration({few}), InputError);
    EXPECT_THROW(learnCalibration({}), InputError);
}
