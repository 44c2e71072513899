// SPDX-License-Identifier: BSD-3-Clause
/** The installed tree, as somebody uses it who never sees the build tree. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
/** Installs into a folder of its own, once for all tests. */
class Install : public testing::Test
{
 protected:
    static void SetUpTestSuite()
    {
        s_folder = std::make_unique<test::TemporaryFolder>();
        const auto installed = test::runProgram(
            VOXELAND_CMAKE, {"--install", VOXELAND_TEST_BINARY_DIR, "--prefix", prefix().string()});
        ASSERT_EQ(installed.exitCode, 0) << installed.errors;
    }
    static void TearDownTestSuite() { s_folder.reset(); }

    [[nodiscard]] static fs::path prefix() { return s_folder->path() / "prefix"; }
    /** Runs an installed program in a folder that has nothing to do with it. */
    [[nodiscard]] static test::ProgramResult run(const std::string& program,
                                                 const std::vector<std::string>& arguments)
    {
        return test::runProgramIn("/", (prefix() / "bin" / program).string(), arguments);
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
};

std::unique_ptr<test::TemporaryFolder> Install::s_folder;

void expectContains(const test::ProgramResult& result, const std::string& part)
{
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
}
}  // namespace

TEST_F(Install, programsFindTheirPlugins)
{
    EXPECT_TRUE(fs::exists(prefix() / VOXELAND_PLUGIN_INSTALL_DIR / "recorded_instances.so"));
    const auto listed = run("rawlog2voxeland", {"--list-plugins"});
    expectContains(listed, "CRecordedInstancesConverter");
    expectContains(listed, "CEvidentialAssociation");
    EXPECT_EQ(run("rawlog2voxeland", {"--check-config"}).exitCode, 0);
}

TEST_F(Install, dataAreThere)
{
    const fs::path share = prefix() / "share" / "voxeland";
    EXPECT_TRUE(fs::exists(share / "labels" / "coco80.csv"));
    const auto checked = run("rawlog2voxeland",
                             {"-c", (share / "config" / "default.ini").string(), "--check-config"});
    EXPECT_EQ(checked.exitCode, 0) << checked.errors;
}

TEST_F(Install, otherProjectsBuildProgramsAndPluginsAgainstIt)
{
    const std::string build = s_folder->file("examples");
    const auto configured = test::runProgram(
        VOXELAND_CMAKE,
        {"-S", VOXELAND_EXAMPLES, "-B", build, "-G", VOXELAND_CMAKE_GENERATOR,
         "-DCMAKE_PREFIX_PATH=" + prefix().string(), "-DCMAKE_CXX_COMPILER=" VOXELAND_CXX,
         "-DCMAKE_CXX_FLAGS=" VOXELAND_CXX_FLAGS});
    ASSERT_EQ(configured.exitCode, 0) << configured.errors;
    const auto built = test::runProgram(VOXELAND_CMAKE, {"--build", build});
    ASSERT_EQ(built.exitCode, 0) << built.output << built.errors;

    const std::string rawlog = s_folder->file("room.rawlog"), map = s_folder->file("room.voxeland");
    const auto simulated = run("voxeland-simulate", {"-o", rawlog, "--rooms", "1", "--frames", "8",
                                                     "--width", "160", "--height", "120"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.errors;
    expectContains(run("rawlog2voxeland", {"-i", rawlog, "-o", map, "--set",
                                           "association.plugin=" + build + "/largest_overlap.so",
                                           "--set", "association.class=example::CLargestOverlap",
                                           "--set", "association.min_voxels=2"}),
                   "8 mapped");

    const auto counted = test::runProgram(build + "/count_objects", {map});
    EXPECT_EQ(counted.exitCode, 0) << counted.errors;
    EXPECT_GE(std::stoi(counted.output), 1) << "a furnished room without an object";
}
