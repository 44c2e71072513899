// SPDX-License-Identifier: BSD-3-Clause
#include "support/GermanNumbers.h"
#include "voxeland/base/errors.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
std::string refusal(const std::string& text)
{
    try {
        MapperConfig(Ini::fromText(text, "my.ini"));
    } catch (const ConfigurationError& e) {
        return e.what();
    }
    return "accepted";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST(MapperConfig, HasDefaultsForEverything)
{
    const MapperConfig config;
    EXPECT_EQ(config.map.resolution, 0.05);
    EXPECT_EQ(config.map.occupancy.prob_hit, 0.7);
    EXPECT_EQ(config.map.occupancy.prob_miss, 0.4);
    EXPECT_EQ(config.map.occupancy.prob_min, 0.12);
    EXPECT_EQ(config.map.occupancy.prob_max, 0.97);
    EXPECT_EQ(config.integration.unknown_weight, 0.2);
    EXPECT_EQ(config.integration.missed_share, 0.5);
    EXPECT_EQ(config.refinement.every, 30u);
    ASSERT_TRUE(config.converter);
    ASSERT_TRUE(config.association);
    for (const char* section :
         {"[voxeland]", "[map]", "[converter]", "[association]", "[refinement]"})
        EXPECT_TRUE(contains(config.text(), section)) << section;
}

TEST(MapperConfig, ItsTextReadsBack)
{
    const MapperConfig config(
        Ini::fromText("[map]\nresolution = 0.1\n[voxeland]\nthreads = 3\n[association]\n"
                      "class = CIoUAssociation\ntau_iou = 0.4\n",
                      "my.ini"));
    const MapperConfig again(Ini::fromText(config.text(), "again"));
    EXPECT_EQ(again.text(), config.text());
    EXPECT_EQ(again.map.resolution, 0.1);
    EXPECT_EQ(again.input.threads, 3u);
    EXPECT_TRUE(contains(again.text(), "CIoUAssociation"));
}

TEST(MapperConfig, ItsCommonKeysAreThoseThatUsersChange)
{
    const auto keysOf = [](const std::string& text) {
        std::istringstream lines(text);
        size_t count = 0;
        for (std::string line; std::getline(lines, line);) count += line.find(" = ") < line.size();
        return count;
    };
    const MapperConfig config;
    EXPECT_LE(keysOf(config.commonText()), 24U);
    EXPECT_GT(keysOf(config.text()), 2 * keysOf(config.commonText()));
    EXPECT_TRUE(contains(config.commonText(), "max_depth = 4"));
    EXPECT_FALSE(contains(config.commonText(), "tau_iou"));
    const MapperConfig changed(Ini::fromText("[association]\ntau_iou = 0.4\n", "my.ini"));
    EXPECT_TRUE(contains(changed.commonText(), "tau_iou = 0.4"));
    EXPECT_FALSE(contains(changed.commonText(), "tau_piece"));
    EXPECT_EQ(MapperConfig(Ini::fromText(changed.commonText(), "again")).text(), changed.text());
}

TEST(MapperConfig, NumbersAreReadAndPrintedAlikeInEveryLocale)
{
    const std::string ini =
        "[map]\nresolution = $eval{0.05/2}\nprob_hit = 0.65\n"
        "[refinement]\nevery = 12345\n";
    const auto text = [&] { return MapperConfig(Ini::fromText(ini, "my.ini")).text(); };
    const std::string classic = text();
    EXPECT_TRUE(contains(classic, "resolution = 0.025\n"));
    {
        const test::GermanNumbers here;
        EXPECT_EQ(text(), classic);
        if (!here.isComplete()) GTEST_SKIP() << "C's functions: de_DE is not installed";
    }
}

TEST(MapperConfig, WhatIsStoredWithAMapDoesNotDependOnThreads)
{
    const auto text = [](const std::string& threads) {
        return MapperConfig(Ini::fromText("[voxeland]\nthreads = " + threads + "\n", "my.ini"))
            .reproducibleText();
    };
    EXPECT_EQ(text("1"), text("7"));
}

TEST(MapperConfig, AllProblemsOfAllSectionsAreInOneMessage)
{
    const std::string message = refusal(
        "[map]\nresolutoin = 0.1\nprob_miss = 0.9\n[voxeland]\nthreads = two\n"
        "[convertor]\nx = 1\n[association]\ntau_iuo = 0.3\n[refinement]\nevery = -1\n");
    for (const char* part :
         {"my.ini", "'resolution'", "prob_miss", "threads", "[converter]", "'tau_iou'", "every"})
        EXPECT_TRUE(contains(message, part)) << part << ": " << message;
    EXPECT_FALSE(contains(message, "\n"));
}

TEST(MapperConfig, ValuesThatDoNotGoTogetherAreProblems)
{
    EXPECT_TRUE(contains(refusal("[voxeland]\nmin_depth = 5\nmax_depth = 4\n"), "min_depth"));
    EXPECT_TRUE(contains(refusal("[map]\nprob_min = 0.45\n"), "prob_min"));
    EXPECT_EQ(refusal("[map]\nresolution = 0.1\n"), "accepted");
}

TEST(MapperConfig, KeysThatChooseAPluginMayBeCapitalizedAsAllOthers)
{
    const MapperConfig config(Ini::fromText(
        "[association]\nPlugin = iou_association\nClass = CIoUAssociation\nSame_Category = no\n",
        "my.ini"));
    EXPECT_TRUE(contains(config.association->description(), "intersection over union and"));
}

TEST(MapperConfig, AMissingPluginDoesNotHideTheOtherProblems)
{
    try {
        MapperConfig(
            Ini::fromText("[map]\nresolutoin = 0.1\n[converter]\nclass = CNoSuchClass\n"
                          "[association]\nplugin = no_such_plugin\ntau = 1\n"
                          "[refinement]\nevery = -1\n",
                          "my.ini"));
        FAIL() << "accepted";
    } catch (const PluginError& e) {
        const std::string message = e.what();
        for (const char* part :
             {"my.ini", "'resolution'", "CNoSuchClass", "no_such_plugin", "every"})
            EXPECT_TRUE(contains(message, part)) << part << ": " << message;
        EXPECT_FALSE(contains(message, "'tau'")) << "the plugin might know it: " << message;
    }
}

TEST(MapperConfig, UnknownPoseSourcesAndDisambiguationKeysAreFound)
{
    const auto problem = [](const std::string& ini) {
        try {
            MapperConfig(Ini::fromText(ini, "the test"));
        } catch (const ConfigurationError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_NE(problem("[voxeland]\npose_source = gps\n").find("robot_pose"), std::string::npos);
    EXPECT_NE(problem("[voxeland]\npose_source = tum:\n").find("tum:<file>"), std::string::npos);
    EXPECT_EQ(problem("[voxeland]\npose_source = tum:any.tum\n"), "");
    EXPECT_NE(problem("[disambiguation]\nentropy_treshold = 1\n").find("entropy_threshold"),
              std::string::npos);
    EXPECT_EQ(problem("[disambiguation]\nclass = CReplayDisambiguator\n"
                      "folder = q\ncrop_margin = 0.5\n"),
              "");
}
