// SPDX-License-Identifier: BSD-3-Clause
/** The installed tree, as somebody uses it who never sees the build tree. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <sstream>

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

    /** Configures somebody else's project against the installed tree. */
    [[nodiscard]] static test::ProgramResult configure(const std::string& source,
                                                       const std::string& build,
                                                       std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"-S",
                                           source,
                                           "-B",
                                           build,
                                           "-G",
                                           VOXELAND_CMAKE_GENERATOR,
                                           "-DCMAKE_PREFIX_PATH=" + prefix().string(),
                                           "-DCMAKE_CXX_COMPILER=" VOXELAND_CXX,
                                           "-DCMAKE_CXX_FLAGS=" VOXELAND_CXX_FLAGS};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::runProgram(VOXELAND_CMAKE, arguments);
    }
    /** Configures and builds it. */
    static void build(const std::string& source, const std::string& folder,
                      const std::vector<std::string>& more = {})
    {
        const auto configured = configure(source, folder, more);
        ASSERT_EQ(configured.exitCode, 0) << configured.errors;
        const auto built = test::runProgram(VOXELAND_CMAKE, {"--build", folder});
        ASSERT_EQ(built.exitCode, 0) << built.output << built.errors;
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
    for (const char* key :
         {"association.class=CIoUAssociation", "converter.class=CPixelLabelsConverter",
          "disambiguation.class=CReplayDisambiguator"})
        EXPECT_EQ(run("rawlog2voxeland", {"--set", key, "--check-config"}).exitCode, 0) << key;
}

TEST_F(Install, dataAreThere)
{
    const fs::path share = prefix() / "share" / "voxeland";
    EXPECT_TRUE(fs::exists(share / "labels" / "coco80.csv"));
    const auto checked = run("rawlog2voxeland",
                             {"-c", (share / "config" / "default.ini").string(), "--check-config"});
    EXPECT_EQ(checked.exitCode, 0) << checked.errors;
}

TEST_F(Install, everyProgramHasAManPage)
{
    size_t pages = 0;
    for (const auto& program : fs::directory_iterator(prefix() / "bin")) {
        const std::string name = program.path().filename().string();
        const fs::path file = prefix() / "share" / "man" / "man1" / (name + ".1.gz");
        const auto page = test::runProgram("zcat", {file.string()});
        for (const char* section :
             {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLES", "\"EXIT STATUS\""})
            expectContains(page, std::string("\n.SH ") + section + "\n");
        pages++;
    }
    EXPECT_GE(pages, 9U);
}

TEST_F(Install, otherProjectsBuildProgramsAndPluginsAgainstIt)
{
    const std::string examples = s_folder->file("examples");
    ASSERT_NO_FATAL_FAILURE(build(VOXELAND_EXAMPLES, examples));

    const std::string rawlog = s_folder->file("room.rawlog"), map = s_folder->file("room.voxeland");
    const auto simulated = run("voxeland-simulate", {"-o", rawlog, "--rooms", "1", "--frames", "8",
                                                     "--width", "160", "--height", "120"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.errors;
    expectContains(run("rawlog2voxeland", {"-i", rawlog, "-o", map, "--set",
                                           "association.plugin=" + examples + "/largest_overlap.so",
                                           "--set", "association.class=example::CLargestOverlap",
                                           "--set", "association.min_voxels=2"}),
                   "8 mapped");

    const auto counted = test::runProgram(examples + "/count_objects", {map});
    EXPECT_EQ(counted.exitCode, 0) << counted.errors;
    EXPECT_GE(std::stoi(counted.output), 1) << "a furnished room without an object";
}

TEST_F(Install, componentsAreLibrariesOfTheirOwn)
{
    const std::string folder = s_folder->file("components");
    ASSERT_NO_FATAL_FAILURE(
        build(VOXELAND_COMPONENTS, folder,
              {"-DCOMPONENTS=core;datasets;disambiguation;evaluation;simulation"}));
    for (const char* component : {"datasets", "disambiguation", "evaluation", "simulation"}) {
        const auto result = test::runProgram(folder + "/uses_" + component, {});
        EXPECT_EQ(result.exitCode, 0) << component << ": " << result.errors;
    }
}

TEST_F(Install, aComponentBringsThoseItNeeds)
{
    ASSERT_NO_FATAL_FAILURE(
        build(VOXELAND_COMPONENTS, s_folder->file("evaluation"), {"-DCOMPONENTS=evaluation"}));
}

TEST_F(Install, anUnknownComponentIsNamedWithThoseThereAre)
{
    const auto result =
        configure(VOXELAND_COMPONENTS, s_folder->file("unknown"), {"-DCOMPONENTS=core;navigation"});
    EXPECT_NE(result.exitCode, 0);
    // CMake fills the lines of messages anew.
    std::string words;
    std::istringstream errors(result.errors);
    for (std::string word; errors >> word;) words += word + " ";
    EXPECT_NE(words.find("voxeland has no component 'navigation'; its components are core, plugin, "
                         "datasets, disambiguation, evaluation, simulation"),
              std::string::npos)
        << result.errors;
}
