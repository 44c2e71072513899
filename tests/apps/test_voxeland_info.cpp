// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-info, run as a user does. */
#include "WallMap.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace voxeland;
using nlohmann::json;

namespace
{
class VoxelandInfo : public testing::Test
{
 protected:
    VoxelandInfo() { test::writeWallMap(map()); }

    [[nodiscard]] std::string map() const { return m_folder.file("wall.voxeland"); }
    [[nodiscard]] test::ProgramResult ask(std::vector<std::string> options) const
    {
        options.insert(options.begin(), map());
        return test::runProgram("voxeland-info", options);
    }
    [[nodiscard]] json askJson(std::vector<std::string> options) const
    {
        options.emplace_back("--json");
        const auto result = ask(options);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return json::parse(result.output);
    }

    test::TemporaryFolder m_folder;
};

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST_F(VoxelandInfo, summary)
{
    const auto result = ask({});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.errors, "");
    for (const char* text : {"0.05 m", "1 chair", "frames         5"})
        EXPECT_TRUE(has(result.output, text)) << text << " in\n" << result.output;
    const json summary = askJson({});
    EXPECT_EQ(summary["frames"], 5);
    EXPECT_EQ(summary["categories"], (json{{"chair", 1}}));
}

TEST_F(VoxelandInfo, instances)
{
    const auto result = ask({"--instances"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(has(result.output, "chair")) << result.output;
    const json all = askJson({"--instances"});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0]["probability"], 1);
    EXPECT_NEAR(all[0]["centroid"][0].get<double>(), 2.025, 1e-9);
    EXPECT_NEAR(all[0]["centroid"][1].get<double>(), 0.54, 0.1);
    EXPECT_EQ(askJson({"--instances", "--min-voxels", "100000"}), json::array());
}

TEST_F(VoxelandInfo, find)
{
    const json found = askJson({"--find", "CHAIR", "--from", "2.025,0.5,-10"});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0]["distance"].get<double>(), 10, 0.2);
    const auto nothing = ask({"--find", "sofa"});
    EXPECT_EQ(nothing.exitCode, 0);
    EXPECT_EQ(nothing.output, "");
    EXPECT_EQ(nothing.errors, "no 'sofa' in this map; it holds: chair (1)\n");
    EXPECT_EQ(askJson({"--find", "sofa"}), json::array());
    EXPECT_EQ(askJson({"--find", "chairs"}).size(), 1U);
    EXPECT_EQ(ask({"--find", "chiar"}).errors,
              "no 'chiar' in this map (did you mean 'chair'?); it holds: chair (1)\n");
    EXPECT_EQ(ask({"--find", "sofa", "--quiet"}).errors, "");
    EXPECT_EQ(ask({"--find", "sofa", "-v", "warn"}).errors, "");
}

TEST_F(VoxelandInfo, at)
{
    const json chair = askJson({"--at", "2.02,0.5,0.0"});
    EXPECT_EQ(chair["instances"][0]["category"], "chair");
    EXPECT_GT(chair["occupancy"], 0.9);
    const json unknown = askJson({"--at", "2.02,-0.5,0"});
    EXPECT_EQ(unknown["instances"][0]["id"], 0);
    const json air = askJson({"--at", "1,0,0"});
    EXPECT_LT(air["occupancy"], 0.5);
    EXPECT_TRUE(air["instances"].empty());
    EXPECT_TRUE(has(ask({"--at", "-50,0,0"}).output, "never observed"));
}

TEST_F(VoxelandInfo, longOptionsTakeTheirValueAfterAnEqualsSignToo)
{
    EXPECT_EQ(askJson({"--at=2.02,0.5,0.0"}), askJson({"--at", "2.02,0.5,0.0"}));
    EXPECT_EQ(askJson({"--find=a=b"}), json::array()) << "the value may hold another";
    for (const char* wrong : {"--at=", "--json=yes", "--bogus=1", "-v=INFO"})
        EXPECT_EQ(ask({wrong}).exitCode, 1) << wrong;
}

TEST_F(VoxelandInfo, whatFollowsTwoDashesIsLeftAsItIs)
{
    const auto result = test::runProgram("voxeland-info", {"--", "--find=a"});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_TRUE(has(result.errors, "--find=a")) << result.errors;
}

TEST_F(VoxelandInfo, reobserve)
{
    const json targets = askJson({"--reobserve", "--camera-height", "0.75", "--most", "1"});
    ASSERT_EQ(targets.size(), 1U);
    EXPECT_TRUE(targets[0]["poses"].is_array());
    EXPECT_TRUE(has(ask({"--reobserve"}).output, " nat  "));
}

TEST_F(VoxelandInfo, wrongUsageIsExitCode1)
{
    for (const auto& options :
         std::vector<std::vector<std::string>>{{"--at", "1,2"},
                                               {"--at", "1,2,x"},
                                               {"--at", "nan,0,0"},
                                               {"--at", "838860.8,0,0"},
                                               {"--find", "chair", "--from", "0,1e300,0"},
                                               {"--instances", "--find", "chair"},
                                               {"--from", "0,0,0"},
                                               {"--most", "3"},
                                               {"--reobserve", "--camera-height", "0"},
                                               {"--reobserve", "--up", "0,0,0"},
                                               {"--reobserve", "--instances"},
                                               {"--bogus"}})
    {
        const auto result = ask(options);
        EXPECT_EQ(result.exitCode, 1) << options[0];
        EXPECT_EQ(result.output, "") << options[0];
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    }
    EXPECT_EQ(test::runProgram("voxeland-info", {}).exitCode, 1);
}

TEST_F(VoxelandInfo, unreadableMapsAreExitCode3)
{
    test::writeFile(m_folder.file("text"), "this is no map");
    const std::string whole = test::readFile(map());
    test::writeFile(m_folder.file("cut"), whole.substr(0, whole.size() / 2));
    for (const char* name : {"absent", "text", "cut"}) {
        const auto result = test::runProgram("voxeland-info", {m_folder.file(name)});
        EXPECT_EQ(result.exitCode, 3) << name;
        EXPECT_TRUE(has(result.errors, m_folder.file(name))) << result.errors;
        EXPECT_EQ(result.output, "");
    }
}

TEST(VoxelandInfoHelp, showsExamples)
{
    const auto result = test::runProgram("voxeland-info", {"--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(has(result.output, "--find chair"));
    EXPECT_EQ(test::runProgram("voxeland-info", {"--version"}).exitCode, 0);
}
