// SPDX-License-Identifier: BSD-3-Clause
#include "support/TestFiles.h"
#include "voxeland/errors.h"
#include "voxeland/plugins/Ini.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    EXPECT_EQ(ini.origin(), "--set map.foo=1");
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
