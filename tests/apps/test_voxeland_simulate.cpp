// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-simulate, run as a user does. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class VoxelandSimulate : public testing::Test
{
 protected:
    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }

    /** A few small frames of one room, with more options. */
    [[nodiscard]] test::ProgramResult simulate(const std::string& output,
                                               const std::vector<std::string>& options = {}) const
    {
        std::vector<std::string> all{"-o",      output, "--rooms",  "1",  "--frames", "4",
                                     "--width", "80",   "--height", "60", "--quiet"};
        all.insert(all.end(), options.begin(), options.end());
        return test::runProgram("voxeland-simulate", all);
    }

    void expectRefused(const test::ProgramResult& result, int exitCode, const std::string& part)
    {
        EXPECT_EQ(result.exitCode, exitCode) << result.errors;
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_TRUE(fs::is_empty(m_folder.path()));
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(VoxelandSimulate, WritesARawlogASidecarImagesAndTheGroundTruth)
{
    const auto result = simulate(path("sim.rawlog"), {"--gt", path("truth")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_NE(result.output.find("4 frames, 1 room,"), std::string::npos) << result.output;
    for (const auto* name :
         {"sim.rawlog", "sim.instances.rawlog", "sim_Images", "truth/ground_truth.ply",
          "truth/categories.csv", "truth/objects.csv", "truth/trajectory.tum"})
        EXPECT_TRUE(fs::exists(path(name))) << name;
}

TEST_F(VoxelandSimulate, EmbedsPredictionsAndImages)
{
    const auto result = simulate(path("sim.rawlog"), {"--embed", "--images", "embedded"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder.path()), {}), 1);
    EXPECT_GT(fs::file_size(path("sim.rawlog")), 10000U);
}

TEST_F(VoxelandSimulate, RepeatsItselfExactlyForTheSameSeed)
{
    ASSERT_EQ(simulate(path("a.rawlog"), {"--seed", "3", "--images", "embedded"}).exitCode, 0);
    ASSERT_EQ(simulate(path("b.rawlog"), {"--seed", "3", "--images", "embedded"}).exitCode, 0);
    ASSERT_EQ(simulate(path("c.rawlog"), {"--seed", "4", "--images", "embedded"}).exitCode, 0);
    const std::string a = test::readFile(path("a.rawlog"));
    EXPECT_TRUE(a == test::readFile(path("b.rawlog")));
    EXPECT_FALSE(a == test::readFile(path("c.rawlog")));
}

TEST_F(VoxelandSimulate, RefusesWrongUsageInOneSentence)
{
    const std::string out = path("sim.rawlog");
    expectRefused(simulate(out, {"--detector", "good"}), 1, "mild, realistic or hard");
    expectRefused(simulate(out, {"--images", "none"}), 1, "embedded or external");
    expectRefused(simulate(out, {"--tracks", "maybe"}), 1, "true or false");
    expectRefused(simulate(out, {"--nonsense"}), 1, "nonsense");
    expectRefused(simulate(path("sim.txt")), 1, ".rawlog");
    expectRefused(test::runProgram("voxeland-simulate", {"-o", out, "--rooms", "4"}), 1,
                  "1, 2 or 3");
    expectRefused(test::runProgram("voxeland-simulate", {"-o", out, "--frames", "0"}), 1, "frames");
    expectRefused(test::runProgram("voxeland-simulate", {}), 1, "give -o <FILE>");
}

TEST_F(VoxelandSimulate, SaysWhereItCannotWrite)
{
    expectRefused(simulate(path("absent/sim.rawlog")), 5, "absent");
    expectRefused(simulate(path("sim.rawlog"), {"--gt", "/dev/null/truth"}), 5, "/dev/null/truth");
}

TEST_F(VoxelandSimulate, ExplainsItself)
{
    const auto help = test::runProgram("voxeland-simulate", {"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const auto* option : {"--seed", "--frames", "--rooms", "--detector", "--gt", "--embed",
                               "--images", "--drift", "--jitter", "--tracks"})
        EXPECT_NE(help.output.find(option), std::string::npos) << option;
    EXPECT_EQ(test::runProgram("voxeland-simulate", {"--version"}).exitCode, 0);
}
