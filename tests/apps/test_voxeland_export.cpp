// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-export, run as a user does. */
#include "WallMap.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

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

TEST_F(VoxelandExport, oneOutputIsEnough)
{
    const auto result = exporting({"--csv", path("w.csv")});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.output, "written: " + path("w.csv") + "\n");
}

TEST_F(VoxelandExport, wrongUsageIsExitCode1)
{
    for (const auto& options :
         std::vector<std::vector<std::string>>{{},
                                               {"--png-dir", path("png"), "--up", "0,0,0"},
                                               {"--png-dir", path("png"), "--up", "up"},
                                               {"--bogus"}})
    {
        const auto result = exporting(options);
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    }
    EXPECT_FALSE(fs::exists(path("png")));
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
    for (const char* option : {"--ply", "--json", "--csv"}) {
        EXPECT_EQ(exporting({option, "/dev/full"}).exitCode, 5) << option;
        EXPECT_EQ(exporting({option, path("absent/file")}).exitCode, 5) << option;
    }
    EXPECT_EQ(exporting({"--png-dir", path("wall.voxeland")}).exitCode, 5);
}
