// SPDX-License-Identifier: BSD-3-Clause
/** The program voxeland-eval, run as a user does. */
#include "WallMap.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

using namespace voxeland;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{
/** A map of a wall whose left half is a chair, and ground truth that says the same. */
class VoxelandEval : public testing::Test
{
 protected:
    VoxelandEval()
    {
        test::writeWallMap(map());
        fs::create_directory(truth());
        std::ostringstream vertices;
        int n = 0;
        for (double y = -0.4; y < 0.4; y += 0.02)
            for (double z = -0.3; z < 0.3; z += 0.02, ++n)
                vertices << "2.02 " << y << " " << z << (y > 0 ? " 1 5\n" : " 0 0\n");
        test::writeFile(truth() + "/ground_truth.ply",
                        "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n) +
                            "\nproperty float x\nproperty float y\nproperty float z\n"
                            "property int instance\nproperty int category\nend_header\n" +
                            vertices.str());
        test::writeFile(truth() + "/categories.csv", "index,name\n0,structure\n5,chair\n");
    }

    [[nodiscard]] std::string map() const { return m_folder.file("wall.voxeland"); }
    [[nodiscard]] std::string truth() const { return m_folder.file("truth"); }
    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] static test::ProgramResult evaluate(const std::vector<std::string>& options)
    {
        return test::runProgram("voxeland-eval", options);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(VoxelandEval, findsTheChair)
{
    const auto result =
        evaluate({"-m", map(), "--gt", truth(), "--format", "ply", "--report", file("r.json"),
                  "--curve", file("c.csv"), "--curve-png", file("c.png"), "--quiet"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_NE(result.output.find("paper9"), std::string::npos) << result.output;
    const json report = json::parse(test::readFile(file("r.json")));
    EXPECT_EQ(report["pooled"]["mean"]["ap50"], 1);
    EXPECT_EQ(report["pooled"]["mean"]["objects"], 1);
    EXPECT_EQ(report["scenes"][0]["name"], "wall");
    EXPECT_EQ(test::readFile(file("c.csv")),
              "threshold_nat,precision,instances,correct\n0.05,1,1,1\n");
    EXPECT_EQ(test::readFile(file("c.png")).substr(1, 3), "PNG");
}

TEST_F(VoxelandEval, averagesScenes)
{
    const auto result = evaluate({"-m", map(), "--gt", truth(), "-m", map(), "--gt",
                                  truth() + "/ground_truth.ply", "--report", file("r.json")});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("Mean over scenes"), std::string::npos);
    EXPECT_EQ(json::parse(test::readFile(file("r.json")))["scenes"].size(), 2U);
}

TEST_F(VoxelandEval, wrongUsageIsOneSentence)
{
    const std::vector<std::vector<std::string>> wrong = {{},
                                                         {"-m", map()},
                                                         {"--score", "luck"},
                                                         {"--void", "maybe"},
                                                         {"--format", "obj"},
                                                         {"--match-radius", "-1"},
                                                         {"--gt", truth()}};
    for (size_t i = 0; i < wrong.size(); ++i) {
        std::vector<std::string> options = wrong[i];
        if (i >= 2) options.insert(options.begin(), {"-m", map(), "--gt", truth(), "--quiet"});
        const auto result = evaluate(options);
        EXPECT_EQ(result.exitCode, 1) << i << ": " << result.errors;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_EQ(result.output, "");
    }
}

TEST_F(VoxelandEval, unreadableInputAndUnwritableOutput)
{
    EXPECT_EQ(evaluate({"-m", file("none.voxeland"), "--gt", truth()}).exitCode, 3);
    EXPECT_EQ(evaluate({"-m", map(), "--gt", file("none")}).exitCode, 3);
    EXPECT_EQ(evaluate({"-m", map(), "--gt", truth(), "--labels", file("none.csv")}).exitCode, 3);
    const auto result =
        evaluate({"-m", map(), "--gt", truth(), "--report", file("no/such/folder/r.json")});
    EXPECT_EQ(result.exitCode, 5) << result.errors;
    EXPECT_EQ(result.errors.find("evaluating"), std::string::npos) << "told before the work";
    EXPECT_EQ(evaluate({"-m", map(), "--gt", truth(), "--report", map()}).exitCode, 1);
}
