// SPDX-License-Identifier: BSD-3-Clause
#include "support/MapBytes.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/map/MapQueries.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace voxeland;

namespace
{
/** A table of three words, and evidence by word. */
struct Said
{
    CategoryTable table;
    CategoryEvidence evidence;

    explicit Said(const std::vector<std::pair<std::string, double>>& words)
    {
        for (const char* name : {"chair", "sofa", "oven"}) table.add(name);
        for (const auto& [word, beta] : words) evidence.add(table.add(word), beta);
    }
    /** What it means, by name. */
    [[nodiscard]] std::map<std::string, double> meant(const Calibration& calibration) const
    {
        std::map<std::string, double> result;
        const CategoryEvidence meant = calibration.applied(evidence, table);
        for (const auto& e : meant.entries()) result[table.name(e.category)] = e.beta;
        return result;
    }
};

const std::map<std::string, Calibration::Meaning> MEANINGS = {
    {"chair", {{"chair", 0.75}, {"sofa", 0.25}}}, {"sofa", {{"sofa", 0.5}, {"unknown", 0.5}}}};
}  // namespace

TEST(Calibration, WordsMeanThemselvesByDefault)
{
    const Said said({{"chair", 2}, {"oven", 0.5}});
    EXPECT_TRUE(Calibration().isIdentity());
    EXPECT_EQ(said.meant(Calibration()),
              (std::map<std::string, double>{{"chair", 2}, {"oven", 0.5}}));
}

TEST(Calibration, AWordMeansWhatItsTableSaysAndTheEvidenceIsAsMuchAsBefore)
{
    auto meant = Said({{"chair", 4}}).meant(Calibration(MEANINGS, 1));
    EXPECT_NEAR(meant["chair"], 3, 1e-12);
    EXPECT_NEAR(meant["sofa"], 1, 1e-12);
    meant = Said({{"chair", 4}}).meant(Calibration(MEANINGS, 2));  // 9/16 : 1/16
    EXPECT_NEAR(meant["chair"], 3.6, 1e-12);
    EXPECT_NEAR(meant["sofa"], 0.4, 1e-12);
}

TEST(Calibration, WordsAreMixedByTheirEvidence)
{
    // 3/4 chair and 1/4 sofa: chair 9/16, sofa 3/16 + 2/16, unknown 2/16; squared 81, 25 and 4.
    auto meant = Said({{"chair", 3}, {"sofa", 1}}).meant(Calibration(MEANINGS, 2));
    EXPECT_NEAR(meant["chair"], 4 * 81.0 / 110, 1e-12);
    EXPECT_NEAR(meant["sofa"], 4 * 25.0 / 110, 1e-12);
    EXPECT_NEAR(meant["unknown"], 4 * 4.0 / 110, 1e-12);
}

TEST(Calibration, AWordWithoutAMeaningIsAnyWordOrItself)
{
    auto meant = Said({{"oven", 2}}).meant(Calibration(MEANINGS, 1));
    EXPECT_NEAR(meant["oven"], 2, 1e-12);
    auto meanings = MEANINGS;
    meanings["*"] = {{"*", 0.75}, {"unknown", 0.25}};
    meant = Said({{"oven", 2}}).meant(Calibration(meanings, 1));
    EXPECT_NEAR(meant["oven"], 1.5, 1e-12);
    EXPECT_NEAR(meant["unknown"], 0.5, 1e-12);
}

TEST(Calibration, WhatTheMapHasNoWordForIsUnknown)
{
    auto meant =
        Said({{"chair", 2}}).meant(Calibration({{"chair", {{"chair", 0.5}, {"yak", 0.5}}}}, 1));
    EXPECT_NEAR(meant["unknown"], 1, 1e-12);
    EXPECT_EQ(meant.count("yak"), 0U);
}

TEST(Calibration, ImpossibleMeaningsAreRefused)
{
    const auto with = [](Calibration::Meaning meaning, double agreement) {
        return Calibration({{"chair", std::move(meaning)}}, agreement);
    };
    EXPECT_NO_THROW(with({{"chair", 1}}, 1));
    EXPECT_THROW(with({{"chair", 0.9}}, 1), std::invalid_argument);
    EXPECT_THROW(with({{"chair", 1.5}, {"sofa", -0.5}}, 1), std::invalid_argument);
    EXPECT_THROW(with({{"chair", std::nan("")}}, 1), std::invalid_argument);
    for (const double agreement : {0.5, 101.0, std::nan("")})
        EXPECT_THROW(with({{"chair", 1}}, agreement), std::invalid_argument);
}

TEST(Calibration, IsReadFromATableThatPeopleEdit)
{
    const test::TemporaryFolder folder;
    const auto read = [&](const std::string& rows) {
        test::writeFile(folder.file("words.csv"), "word,category,probability\n" + rows);
        return Calibration::fromCsv(folder.file("words.csv"), 2);
    };
    const Calibration given(MEANINGS, 2);
    test::writeFile(folder.file("words.csv"), given.csv());
    EXPECT_EQ(Calibration::fromCsv(folder.file("words.csv"), 2).csv(), given.csv());
    const auto rounded = read("tv,tv,0.33\ntv,unknown,0.66\n").meanings().at("tv");
    EXPECT_NEAR(rounded.at("tv"), 1.0 / 3, 1e-12);
    for (const char* wrong : {"tv,tv,0.8\n", "tv,tv,1\ntv,tv,1\n", "tv,tv,much\n", "tv,tv\n",
                              "tv,tv,-1\ntv,unknown,2\n"})
        EXPECT_THROW(read(wrong), InputError) << wrong;
    EXPECT_THROW(Calibration::fromCsv(folder.file("none.csv"), 2), InputError);
}

TEST(Calibration, OfAMapIsUndoneExactly)
{
    SemanticVoxelMap map;
    Instance& instance = map.createInstance();
    CategoryEvidence opinion;
    opinion.add(map.categories().add("chair"), 0.8);
    instance.categories.add(opinion, side_t{3});
    map.categories().add("sofa");
    const std::string before = test::bytesOf(map);
    const double p = categoryDistribution(map, instance).front().probability;
    map.setCalibration(Calibration(MEANINGS, 1));
    EXPECT_LT(categoryDistribution(map, instance).front().probability, p);
    EXPECT_NE(test::bytesOf(map), before);
    map.setCalibration({});
    EXPECT_EQ(test::bytesOf(map), before);
}

TEST(Calibration, LeavesDecisionsAsTheyAre)
{
    SemanticVoxelMap map;
    Instance& instance = map.createInstance();
    Decision decision;
    decision.category = map.categories().add("chair");
    decision.evidence = 5;
    instance.decisions.push_back(decision);
    map.setCalibration(Calibration(MEANINGS, 1));
    EXPECT_EQ(map.categoryEvidence(instance).betaOf(decision.category), 5);
}
