// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-report, run as a user does. */
#include "WallMap.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class VoxelandReport : public testing::Test
{
 protected:
    VoxelandReport()
    {
        test::writeWallMap(path("wall.voxeland"));
        fs::create_directories(path("three/examples/js/controls"));
        test::writeFile(path("three/three.min.js"), "/* three */");
        test::writeFile(path("three/examples/js/controls/OrbitControls.js"), "/* orbit */");
    }

    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] test::ProgramResult reporting(std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"-m", path("wall.voxeland"), "--three", path("three")});
        return test::runProgram("voxeland-report", options);
    }

    test::TemporaryFolder m_folder;
};

constexpr const char* TIMES =
    "frame,detection_ms,decode_ms,voxelize_ms,opinions_ms,rays_ms,association_ms,integration_ms,"
    "refinement_ms\n"
    "0,0,1,2,3,4,5,6,0\n"
    "1,0,1,2,3,8,5,6,7\n";

/** A wall of 40 x 40 points of a chair, where the map has its chair. */
void writeTruth(const std::string& folder)
{
    fs::create_directories(folder);
    std::string points;
    for (int y = 0; y < 40; ++y)
        for (int z = 0; z < 40; ++z)
            points += "2.02 " + std::to_string(0.05 + y * 0.02) + " " +
                      std::to_string(-0.4 + z * 0.02) + " 1 0\n";
    test::writeFile(folder + "/ground_truth.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1600\nproperty float x\nproperty float "
                    "y\nproperty float z\nproperty int instance\nproperty int category\n"
                    "end_header\n" +
                        points);
    test::writeFile(folder + "/categories.csv", "index,name\n0,chair\n");
}
}  // namespace

TEST_F(VoxelandReport, writesAPage)
{
    const auto result = reporting({"-o", path("w.html"), "--title", "A wall"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, "written: " + path("w.html") + "\n");
    EXPECT_EQ(result.errors, "");
    const std::string page = test::readFile(path("w.html"));
    EXPECT_NE(page.find("<title>A wall</title>"), std::string::npos);
    EXPECT_NE(page.find("/* orbit */"), std::string::npos);
    EXPECT_NE(page.find(R"("timing":"")"), std::string::npos);
}

TEST_F(VoxelandReport, withTimesAndEvaluation)
{
    test::writeFile(path("times.csv"), TIMES);
    writeTruth(path("truth"));
    const auto result =
        reporting({"-o", path("w.html"), "--timing", path("times.csv"), "--gt", path("truth")});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    const std::string page = test::readFile(path("w.html"));
    EXPECT_NE(page.find("rays              8.000    6.000        2"), std::string::npos)
        << "of two, the upper is the median";
    EXPECT_NE(page.find("refinement        7.000    7.000        1"), std::string::npos);
    EXPECT_EQ(page.find(R"("evaluation":"")"), std::string::npos);
}

TEST_F(VoxelandReport, failures)
{
    EXPECT_EQ(reporting({}).exitCode, 1);
    EXPECT_EQ(reporting({"-o", path("wall.voxeland")}).exitCode, 1);
    EXPECT_EQ(reporting({"-o", path("absent/w.html")}).exitCode, 5);
    EXPECT_EQ(reporting({"-o", "/dev/full"}).exitCode, 5);
    EXPECT_EQ(reporting({"-o", path("w.html"), "--gt", path("absent")}).exitCode, 3);
    test::writeFile(path("times.csv"), std::string(TIMES) + "2,1,2\n");
    for (const char* times : {"times.csv", "absent", "wall.voxeland"})
        EXPECT_EQ(reporting({"-o", path("w.html"), "--timing", path(times)}).exitCode, 3) << times;
    const auto result = test::runProgram(
        "voxeland-report",
        {"-m", path("wall.voxeland"), "-o", path("w.html"), "--three", path("absent")});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.errors.find("libjs-three"), std::string::npos) << result.errors;
    EXPECT_FALSE(fs::exists(path("w.html")));
}
