// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-export, run as a user does. */
#include "WallMap.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class VoxelandExport : public testing::Test
{
 protected:
    VoxelandExport() { test::writeWallMap(path("wall.voxeland")); }

    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] test::ProgramResult exporting(std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"-m", path("wall.voxeland")});
        return test::runProgram("voxeland-export", options);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(VoxelandExport, writesWhatIsAskedForAndNamesIt)
{
    const auto result = exporting({"--ply", path("w.ply"), "--json", path("w.json"), "--csv",
                                   path("w.csv"), "--png-dir", path("png")});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 13);
    for (const char* name : {"w.ply", "w.json", "w.csv", "png/categories_top.png"}) {
        EXPECT_TRUE(fs::is_regular_file(path(name))) << name;
        EXPECT_NE(result.output.find("written: " + path(name) + "\n"), std::string::npos) << name;
    }
}

TEST_F(VoxelandExport, everyFormat)
{
    const auto result =
        exporting({"--per-instance", path("each"), "--glb", path("w.glb"), "--scene",
                   path("w.3Dscene"), "--octomap", path("w.bt"), "--gridmap", path("w.gridmap"),
                   "--ros-map", path("w.yaml"), "--points", path("w.txt"), "--category", "chair"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    for (const char* name : {"each/0_unknown.ply", "each/1_chair.ply", "w.glb", "w.3Dscene", "w.bt",
                             "w.gridmap", "w.yaml", "w.pgm", "w.txt"})
    {
        EXPECT_TRUE(fs::is_regular_file(path(name))) << name;
        EXPECT_NE(result.output.find("written: " + path(name) + "\n"), std::string::npos) << name;
    }
    // The lowest points are 23 rows below the middle: -23 / 60 * 2.02 m. The floor is the top of
    // the voxels that hold them.
    EXPECT_EQ(result.errors, "heights are along (0.000, 0.000, 1.000), from -0.75 m\n");
}

TEST_F(VoxelandExport, smallInstancesAreUnknownIfAskedFor)
{
    EXPECT_EQ(exporting({"--csv", path("w.csv"), "--min-voxels", "100000"}).exitCode, 0);
    const std::string table = test::readFile(path("w.csv"));
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1) << "the header";
}

TEST_F(VoxelandExport, oneOutputIsEnough)
{
    const auto result = exporting({"--csv", path("w.csv")});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.output, "written: " + path("w.csv") + "\n");
}

TEST_F(VoxelandExport, wrongUsageIsExitCode1)
{
    for (const auto& options : std::vector<std::vector<std::string>>{
             {},
             {"--png-dir", path("png"), "--up", "0,0,0"},
             {"--png-dir", path("png"), "--up", "up"},
             {"--csv", path("c"), "--height", "0,1"},
             {"--gridmap", path("g"), "--height", "1,0"},
             {"--csv", path("c"), "--category", "cup"},
             {"--ros-map", path("no.yml")},
             {"--octomap", path("no.oct")},
             {"--ros-map", path("a.yaml"), "--ply", path("a.pgm")},
             {"--gridmap", path("g"), "--height", "50,51", "--quiet"},
             {"--bogus"}})
    {
        const auto result = exporting(options);
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    }
    EXPECT_FALSE(fs::exists(path("png")));
}

TEST_F(VoxelandExport, aNameOfAnotherFormatIsRefused)
{
    for (const char* option : {"--ply", "--json", "--csv", "--glb", "--scene", "--octomap",
                               "--gridmap", "--ros-map", "--points"})
    {
        const auto result = exporting({option, path("x.obj")});
        EXPECT_EQ(result.exitCode, 1) << option;
        EXPECT_NE(result.errors.find("x.obj' must end in ."), std::string::npos) << result.errors;
        EXPECT_FALSE(fs::exists(path("x.obj"))) << option;
    }
    EXPECT_EQ(exporting({"--ply", path("X.PLY"), "--csv", path("table")}).exitCode, 0);
    EXPECT_EQ(exporting({"--per-instance", path("each"), "--json", path("each/a.json")}).exitCode,
              0);
    EXPECT_EQ(exporting({"--json", path("tmp.Zq3xAb"), "--csv", path("map_0.05")}).exitCode, 0);
}

TEST_F(VoxelandExport, anUnreadableMapIsExitCode3)
{
    const auto result =
        test::runProgram("voxeland-export", {"-m", path("absent"), "--csv", path("w.csv")});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_FALSE(fs::exists(path("w.csv")));
}

TEST_F(VoxelandExport, unwritableOutputIsExitCode5)
{
    for (const char* option : {"--ply", "--json", "--csv", "--glb"})
        EXPECT_EQ(exporting({option, "/dev/full"}).exitCode, 5) << option;
    for (const char* option : {"--ply", "--json", "--csv", "--glb", "--scene", "--gridmap"}) {
        EXPECT_EQ(exporting({option, path("absent/file")}).exitCode, 5) << option;
    }
    EXPECT_EQ(exporting({"--png-dir", path("wall.voxeland")}).exitCode, 5);
}
