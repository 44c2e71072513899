// SPDX-License-Identifier: BSD-3-Clause
/** A scene laid out as SceneNN publishes it, from its images to the table of figures. */
#include "support/Room.h"
#include "support/RunProgram.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace voxeland;
using nlohmann::json;
using test::Room;
namespace fs = std::filesystem;

namespace
{
const PinholeCamera CAMERA = {120, 120, 79.5, 59.5, {}};

/** The room, with a flat television on the wall x = 4 m: y in [1.6, 2.8], z in [0.9, 1.9]. */
class SceneNNScene : public testing::Test
{
 protected:
    SceneNNScene()
    {
        std::string trajectory;
        for (int i = 0; i < FRAMES; ++i) {
            const auto pose = Room::cameraToWorld(i);
            const std::string number = std::to_string(100001 + i).substr(1);
            test::writeImage(scene() / ("image/image" + number + ".png"),
                             test::greyImage(160, 120));
            test::writeImage(scene() / ("depth/depth" + number + ".png"),
                             Room::depth(pose, CAMERA, 160, 120, 1000));
            trajectory += std::to_string(i) + " " + std::to_string(i) + " " +
                          std::to_string(i + 1) + "\n" + test::matrixText(pose);
        }
        test::writeFile(scene() / "trajectory.log", trajectory);
        test::writeFile(scene() / "asus.ini", "fx 120\nfy 120\ncx 79.5\ncy 59.5\n");
        std::ostringstream vertices;
        int n = 0;
        for (double y = 0.01; y < 5; y += 0.02)
            for (double z = 0.01; z < 3; z += 0.02, ++n) {
                const bool onTelevision = y > 1.6 && y < 2.8 && z > 0.9 && z < 1.9;
                vertices << "3.99 " << y << " " << z << (onTelevision ? " 12\n" : " 4\n");
            }
        test::writeFile(scene() / "011.ply",
                        "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n) +
                            "\nproperty float x\nproperty float y\nproperty float z\n"
                            "property uint label\nend_header\n" +
                            vertices.str());
        test::writeFile(scene() / "011.xml",
                        "<annotation><label id=\"4\" text=\"wall\" nyu_class=\"wall\"/>"
                        "<label id=\"12\" text=\"tv\" nyu_class=\"television\"/></annotation>");
    }
    static constexpr int FRAMES = 20;
    [[nodiscard]] fs::path scene() const { return m_folder.path() / "011"; }
    [[nodiscard]] std::string file(const std::string& name) const { return m_folder.file(name); }
    [[nodiscard]] test::ProgramResult import(const std::vector<std::string>& options) const
    {
        std::vector<std::string> all = {"--format", "scenenn", "--input", scene().string()};
        all.insert(all.end(), options.begin(), options.end());
        return test::runProgram("rgbd2rawlog", all);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(SceneNNScene, HoldsTogether)
{
    const auto good = import({"--check"});
    EXPECT_EQ(good.exitCode, 0) << good.output;
    EXPECT_NE(good.output.find("hold together"), std::string::npos) << good.output;
    const auto inverted = import({"--check", "--invert-poses"});
    EXPECT_EQ(inverted.exitCode, 3) << inverted.output;
    EXPECT_NE(inverted.output.find("--invert-poses"), std::string::npos) << inverted.output;
}

TEST_F(SceneNNScene, AnOracleDetectorFindsTheTelevision)
{
    const auto imported = import({"--predictions", "gt", "--output", file("011.rawlog")});
    ASSERT_EQ(imported.exitCode, 0) << imported.errors;
    EXPECT_NE(imported.output.find("frames: 20 of 20 in SceneNN\npredictions: 20\n"),
              std::string::npos)
        << imported.output;
    const auto mapped =
        test::runProgram("rawlog2voxeland", {"-i", file("011.rawlog"), "-o", file("011.voxeland"),
                                             "--set", "association.class=CTrackAssociation"});
    ASSERT_EQ(mapped.exitCode, 0) << mapped.errors;
    const auto evaluated =
        test::runProgram("voxeland-eval", {"-m", file("011.voxeland"), "--gt", scene().string(),
                                           "--format", "scenenn", "--report", file("r.json")});
    ASSERT_EQ(evaluated.exitCode, 0) << evaluated.errors;
    const json report = json::parse(test::readFile(file("r.json")));
    EXPECT_EQ(report["pooled"]["mean"]["objects"], 1);
    EXPECT_EQ(report["pooled"]["mean"]["ap50"], 1);
}
