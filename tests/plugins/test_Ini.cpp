// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/plugins/Ini.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

using namespace voxeland;

TEST(Ini, ReadsSectionsKeysAndValues)
{
    const Ini ini = Ini::fromText(
        "# a comment\n[map]\nresolution = 0.1 // of a voxel [m]\nprob_hit=0.6\n\n[empty]\n",
        "a text");
    EXPECT_EQ(ini.origin(), "a text");
    EXPECT_EQ(ini.folder(), "");
    EXPECT_EQ(ini.value("map", "resolution"), "0.1");
    auto keys = ini.keys("map");
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(keys, (std::vector<std::string>{"prob_hit", "resolution"}));
    EXPECT_TRUE(ini.keys("nothing").empty());
    const auto sections = ini.sections();
    EXPECT_EQ(std::count(sections.begin(), sections.end(), "map"), 1);
}

TEST(Ini, AByteOrderMarkAndCarriageReturnsAreNoPartOfIt)
{
    const Ini ini = Ini::fromText(
        "\xEF\xBB\xBF[map]\r\nresolution = 0.1\r\nprob_hit=\\\r\n0.6\r\n[association]\rclass = C\r",
        "a text");
    EXPECT_EQ(ini.value("map", "resolution"), "0.1");
    EXPECT_EQ(ini.value("map", "prob_hit"), "0.6");
    EXPECT_EQ(ini.value("association", "class"), "C");
}

TEST(Ini, WhatAnOptionSetIsNamedAsItsOrigin)
{
    Ini ini;
    EXPECT_EQ(ini.origin(), "the defaults");
    ini.set("map.resolution=0.1");
    EXPECT_EQ(ini.origin(), "the defaults");
    ini.set("map.foo=1", "--set");
    EXPECT_EQ(ini.origin(), "--set map.foo");
}

TEST(Ini, KnowsItsFileAndFolder)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder.file("my.ini"), "[map]\nresolution=0.2\n");
    const Ini ini = Ini::fromFile(folder.file("my.ini"));
    EXPECT_EQ(ini.origin(), folder.file("my.ini"));
    EXPECT_EQ(ini.folder(), folder.path().string());
    EXPECT_EQ(ini.value("map", "resolution"), "0.2");
}

TEST(Ini, MissingFilesAreNoSilentDefaults)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(Ini::fromFile(folder.file("missing.ini")), ConfigurationError);
    EXPECT_THROW(Ini::fromFile(folder.path().string()), ConfigurationError);
}

TEST(Ini, TakesAssignmentsOfTheCommandLine)
{
    Ini ini;
    ini.set("map.resolution=0.1");
    ini.set("voxeland.pose_source=tum:/a/b.c=d.tum");
    ini.set("converter.min_score=");
    EXPECT_EQ(ini.value("map", "resolution"), "0.1");
    EXPECT_EQ(ini.value("voxeland", "pose_source"), "tum:/a/b.c=d.tum");
    ini.set("map.resolution=0.2");
    EXPECT_EQ(ini.value("map", "resolution"), "0.2");
    for (const char* wrong :
         {"", "map", "map.resolution", "resolution=1", ".key=1", "map.=1", "a=b.c"})
        EXPECT_THROW(ini.set(wrong), ConfigurationError) << wrong;
}

TEST(Ini, AssignmentsGoBeforeWhatTheFileSays)
{
    Ini ini = Ini::fromText("[map]\nresolution=0.1\n", "a text");
    ini.set("map.resolution=0.3");
    EXPECT_EQ(ini.value("map", "resolution"), "0.3");
    EXPECT_EQ(Ini::fromText(ini.text(), "again").value("map", "resolution"), "0.3");
}

TEST(Ini, TakesOverPrefixedSections)
{
    const mrpt::config::CConfigFileMemory program(
        std::string("[slam_map]\nresolution=9\n[slam_voxelandMap_00_map]\nresolution=0.2\n"
                    "[slam_voxelandMap_00_other]\nkey=1\n[map]\nresolution=8\n"));
    Ini ini = Ini::fromText("[map]\nresolution=0.1\nprob_hit=0.6\n", "a text");
    ini.setFromPrefixedSections(program, "slam_voxelandMap_00", {"map", "converter"});
    EXPECT_EQ(ini.value("map", "resolution"), "0.2");
    EXPECT_EQ(ini.value("map", "prob_hit"), "0.6");
    EXPECT_TRUE(ini.keys("other").empty());
}

TEST(Ini, NothingInAMapIsExpanded)
{
    setenv("VOXELAND_TEST_VALUE", "expanded", 1);
    const Ini ini = Ini::fromMap(
        "@define A b\n[map]\nx = $env{VOXELAND_TEST_VALUE}\ny = ${A}\nz = $eval{1+1}\nprice = 3$\n",
        "m.voxeland");
    EXPECT_EQ(ini.value("map", "x"), "$env{VOXELAND_TEST_VALUE}");
    EXPECT_EQ(ini.value("map", "y"), "${A}");
    EXPECT_EQ(ini.value("map", "z"), "$eval{1+1}");
    EXPECT_EQ(ini.value("map", "price"), "3$");
    EXPECT_EQ(ini.origin(), "m.voxeland");
}

TEST(Ini, KnowsWhatWasWrittenForTheEnvironment)
{
    setenv("VOXELAND_TEST_VALUE", "expanded", 1);
    Ini ini = Ini::fromText(
        "@define A $env{VOXELAND_TEST_VALUE}\n@define B 2\n[s]\nx = ${A}/y\nz = ${B}\n", "a text");
    EXPECT_EQ(ini.value("s", "x"), "expanded/y");
    EXPECT_EQ(ini.written("s", "x"), "$env{VOXELAND_TEST_VALUE}/y");
    EXPECT_EQ(ini.written("s", "z"), "2");
    const mrpt::config::CConfigFileMemory others("[p_s]\nx = $env{VOXELAND_TEST_VALUE}\n");
    ini.setFromPrefixedSections(others, "p", {"s"});
    EXPECT_EQ(ini.value("s", "x"), "expanded");
    EXPECT_FALSE(ini.written("s", "x")) << "MRPT expanded it before";
    ini.set("s.X=y");
    EXPECT_EQ(ini.written("s", "x"), "y");
}

TEST(Ini, KnowsWhichValuesAreAMaps)
{
    Ini ini = Ini::fromMap("[Map]\nx = 1\ny = 2\nz = 3\n", "m.voxeland");
    EXPECT_TRUE(ini.isOfMap("map", "X"));
    ini.set("map.X=4");
    const mrpt::config::CConfigFileMemory others("[p_map]\ny = 5\n");
    ini.setFromPrefixedSections(others, "p", {"map"});
    EXPECT_FALSE(ini.isOfMap("Map", "x"));
    EXPECT_FALSE(ini.isOfMap("Map", "y"));
    EXPECT_TRUE(ini.isOfMap("Map", "z"));
    EXPECT_FALSE(Ini::fromText("[map]\nx = 1\n", "a text").isOfMap("map", "x"));
}

TEST(Ini, ControlCharactersAreRefused)
{
    EXPECT_THROW(Ini::fromText("[map]\nx = \x1B[2J\n", "a text"), ConfigurationError);
    EXPECT_THROW(Ini::fromMap("[map]\nx = \x1A\n", "m.voxeland"), ConfigurationError);
    EXPECT_THROW(Ini().set("map.x=a\n[converter]"), ConfigurationError);
    EXPECT_NO_THROW(Ini::fromText("[map]\n\tx = 1\t// one\r\n", "a text"));
}

TEST(Ini, LinesWithAnAtThatDefineNothingAreRefused)
{
    for (const char* line : {"@include nosuch.ini", "@inclde x", "@foo", "@define", "@defines A b"})
        try {
            Ini::fromText(std::string("[map]\n  ") + line + "\nx = 1\n", "my.ini");
            ADD_FAILURE() << "passed over: " << line;
        } catch (const ConfigurationError& e) {
            EXPECT_STREQ(e.what(),
                         "line 2 of 'my.ini' begins with '@' but is not '@define NAME VALUE'");
        }
    EXPECT_EQ(Ini::fromText(" @define\tA 1\n[map]\nx = ${A}\n", "my.ini").value("map", "x"), "1");
}

TEST(Ini, AnExpressionThatIsNoneIsNamedWithoutWhatItHolds)
{
    try {
        Ini::fromText("[map]\nresolution = $eval{system(\"id\")}\n", "my.ini");
        ADD_FAILURE() << "taken";
    } catch (const ConfigurationError& e) {
        EXPECT_STREQ(e.what(),
                     "line 2 of 'my.ini' (resolution) has an $eval{} that is no expression of "
                     "numbers");
    }
    setenv("VOXELAND_TEST_VALUE", "secret+", 1);
    for (const char* expression :
         {"$env{VOXELAND_TEST_VALUE}}", "1 + $env{VOXELAND_TEST_VALUE} +}"})
        try {
            Ini::fromText(std::string("[map]\nresolution = $eval{") + expression + "\n", "my.ini");
            ADD_FAILURE() << "taken: " << expression;
        } catch (const ConfigurationError& e) {
            EXPECT_EQ(std::string(e.what()).find("secret"), std::string::npos) << e.what();
        }
    unsetenv("VOXELAND_TEST_VALUE");
}

TEST(Ini, KeyGivenTwiceInOneSectionIsRefusedWithBothLines)
{
    const std::string once =
        "[map]\nresolution = 0.05\n; resolution = 0.1\n[mapper]\nresolution = 1\n";
    EXPECT_EQ(Ini::fromText(once, "my.ini").value("map", "resolution"), "0.05");
    try {
        Ini::fromText(once + "[ MAP ]\n Resolution=0.02\n", "my.ini");
        FAIL() << "the last one would have won";
    } catch (const ConfigurationError& e) {
        EXPECT_STREQ(e.what(),
                     "line 7 of 'my.ini' gives [MAP] Resolution again: line 2 does too; keep one");
    }
}

TEST(Ini, AMapHoldsNoConfigurationWithoutEnd)
{
    std::string many = "[map]\n", large = "[map]\na = ";
    for (int i = 0; i < 9999; ++i) many += "k" + std::to_string(i) + " = 1\n";
    large.resize((1 << 20) - 1, 'x');
    EXPECT_EQ(Ini::fromMap(many, "m.voxeland").keys("map").size(), 9999U);
    EXPECT_NO_THROW(Ini::fromMap(large + "\n", "m.voxeland"));
    for (const std::string& text : {many + "a = 1\n", large + "xx\n"}) try
        {
            Ini::fromMap(text, "m.voxeland");
            FAIL() << "taken";
        } catch (const ConfigurationError& e) {
            EXPECT_NE(std::string(e.what()).find("'m.voxeland' is longer"), std::string::npos)
                << e.what();
        }
    EXPECT_NO_THROW(Ini::fromText(many + "a = 1\n", "my.ini")) << "of a user";
}
