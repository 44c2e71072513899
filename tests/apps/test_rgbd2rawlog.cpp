// SPDX-License-Identifier: BSD-3-Clause
/** The program rgbd2rawlog, run as a user does. */
#include "files/GzInputFile.h"
#include "support/RunProgram.h"
#include "support/SevenScenes.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <regex>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
/** A mask of 32x24 pixels with none set, as COCO's uncompressed counts. */
const std::string EMPTY_MASK = R"("segmentation": {"size": [24, 32], "counts": [768]})";

std::string prediction(int image, const std::string& mask = EMPTY_MASK)
{
    return R"({"image_id": )" + std::to_string(image) + R"(, "category_id": 62, "score": 0.5, )" +
           mask + "}";
}

class Rgbd2Rawlog : public testing::Test
{
 protected:
    Rgbd2Rawlog()
    {
        for (const char* n : {"0", "1", "2", "3"})
            test::writeSevenScenesFrame(m_folder.path() / "scene" / "seq-01" /
                                        ("frame-00000" + std::string(n)));
    }

    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }

    /** Imports the scene to k.rawlog with further options. */
    [[nodiscard]] test::ProgramResult import(std::vector<std::string> options = {}) const
    {
        for (const std::string& o :
             {std::string("--format"), std::string("7scenes"), std::string("--input"),
              path("scene"), std::string("--output"), path("k.rawlog")})
            options.push_back(o);
        return test::runProgram("rgbd2rawlog", options);
    }
    [[nodiscard]] test::ProgramResult importWith(const std::string& predictions) const
    {
        test::writeFile(path("coco.json"), predictions);
        return import({"--predictions", path("coco.json")});
    }
    void expectNothingWritten() const
    {
        for (const auto& entry : fs::directory_iterator(m_folder.path()))
            EXPECT_TRUE(entry.path().filename() == "scene" ||
                        entry.path().filename() == "coco.json")
                << entry.path();
    }

    test::TemporaryFolder m_folder;
};

/** One line that starts with the program's name and has this in it. */
void expectSentence(const test::ProgramResult& result, int exitCode, const std::string& part)
{
    EXPECT_EQ(result.exitCode, exitCode) << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.errors.rfind("rgbd2rawlog: ", 0), 0U) << result.errors;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
}
}  // namespace

TEST_F(Rgbd2Rawlog, importsAScene)
{
    const auto result = importWith("[" + prediction(0) + "," + prediction(3) + "]");
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output.rfind("frames: 4 of 4 in 7-Scenes\n"
                                  "predictions: 2\n"
                                  "written: " +
                                      path("k.rawlog"),
                                  0),
              0U)
        << result.output;
    for (const char* name : {"k.rawlog", "k.instances.rawlog", "k_Images"})
        EXPECT_TRUE(fs::exists(path(name))) << name;
}

TEST_F(Rgbd2Rawlog, countsPredictionsOfFramesLeftOut)
{
    test::writeFile(path("coco.json"),
                    "[" + prediction(0) + "," + prediction(1) + "," + prediction(2) + "]");
    const auto result = import(
        {"--predictions", path("coco.json"), "--every", "2", "--embed", "--images", "embedded"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("frames: 2 of 4 in 7-Scenes\n"
                                 "predictions: 2, and 1 of frames that were left out\n"),
              std::string::npos)
        << result.output;
    EXPECT_FALSE(fs::exists(path("k.instances.rawlog")));
    EXPECT_FALSE(fs::exists(path("k_Images")));
}

TEST_F(Rgbd2Rawlog, skipsAndCountsFramesWithoutAValidPose)
{
    test::writeFile(path("scene/seq-01/frame-000001.pose.txt"),
                    "1 0 0 0\n0 2 0 0\n0 0 1 0\n0 0 0 1\n");
    fs::remove(path("scene/seq-01/frame-000002.pose.txt"));
    const auto result = import();
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("frames: 2 of 4 in 7-Scenes\n"
                                 "skipped: 1 frame, no pose file "
                                 "(seq-01/frame-000002.color.png)\n"
                                 "skipped: 1 frame, pose is not a rigid transform "
                                 "(seq-01/frame-000001.color.png)\n"),
              std::string::npos)
        << result.output;
}

TEST_F(Rgbd2Rawlog, scalesIntrinsicsOfResizedImagesAndSaysSo)
{
    // The scene's images, of 32x24 pixels, lie in the middle of no camera of 7-Scenes' 640x480.
    fs::remove(path("scene/camera-intrinsics.txt"));
    fs::remove(path("scene/seq-01/camera-intrinsics.txt"));
    const auto result = import();
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(
        result.output.find("note: the depth images have 32x24 pixels, but their camera is of "
                           "640x480: its intrinsics are scaled (--intrinsics gives others)\n"),
        std::string::npos)
        << result.output;
}

TEST_F(Rgbd2Rawlog, colourMayHaveACameraOfItsOwn)
{
    EXPECT_EQ(import({"--color-intrinsics", "29.25, 29.25,15.5,11.5"}).exitCode, 0);
    for (const char* wrong : {"29,29,15", "29,29,15,x", "0,29,15,11", "29,29,15,11,1", "29,29,,11"})
        expectSentence(import({"--color-intrinsics", wrong}), 1, "is not four numbers");
}

TEST_F(Rgbd2Rawlog, checkWritesNothingAndSaysWhatItCannotTell)
{
    const auto result = test::runProgram(
        "rgbd2rawlog", {"--format", "7scenes", "--input", path("scene"), "--check"});
    EXPECT_EQ(result.exitCode, 4) << result.errors;  // the camera stands still
    EXPECT_NE(result.output.find("verdict: no two of the frames"), std::string::npos)
        << result.output;
    expectNothingWritten();
}

TEST_F(Rgbd2Rawlog, checkJudgesTheRealKitchen)
{
    SKIP_WITHOUT_REDKITCHEN();
    const auto check = [](std::vector<std::string> options) {
        for (const auto& o : {"--format", "7scenes", "--check", "--quiet", "--input"})
            options.emplace_back(o);
        options.push_back(test::redkitchen().string());
        return test::runProgram("rgbd2rawlog", options);
    };
    const auto good = check({});
    EXPECT_EQ(good.exitCode, 0) << good.output;
    EXPECT_EQ(good.errors, "");
    EXPECT_NE(good.output.find("verdict: depth scale, intrinsics and poses hold together\n"),
              std::string::npos)
        << good.output;
    const auto wrong = check({"--depth-scale", "5000"});
    EXPECT_EQ(wrong.exitCode, 3) << wrong.output;
    EXPECT_NE(wrong.output.find("use --depth-scale 1000"), std::string::npos) << wrong.output;
}

TEST_F(Rgbd2Rawlog, wrongUsageEndsWithOne)
{
    EXPECT_EQ(test::runProgram("rgbd2rawlog", {}).exitCode, 1);
    expectSentence(test::runProgram("rgbd2rawlog",
                                    {"--format", "8scenes", "--input", path("scene"), "--check"}),
                   1, "7scenes");
    expectSentence(import({"--every", "0"}), 1, "every");
    expectSentence(import({"--images", "nowhere"}), 1, "nowhere");
    expectSentence(import({"--check"}), 1, "--check");
    for (const char* scale : {"0", "-1000", "1e300", "1e-300", "0.99", "1000001"})
        expectSentence(import({"--depth-scale", scale}), 1, "--depth-scale");
    expectSentence(import({"--intrinsics", "525,525"}), 1, "525,525,319.5,239.5");
    expectSentence(import({"--predictions", "gt"}), 1, "no annotation");
    expectSentence(import({"--predictions", "gt", "--categories", "names.csv"}), 1,
                   "--categories needs");
    expectSentence(import({"--categories", path("names.csv")}), 1, "--predictions");
    expectNothingWritten();
}

TEST_F(Rgbd2Rawlog, corruptInputEndsWithThree)
{
    const std::string whole = "[" + prediction(0) + "]";
    expectSentence(importWith(whole.substr(0, whole.size() / 2)), 3, "cut off");
    const std::string small = R"("segmentation": {"size": [2, 2], "counts": [4]})";
    expectSentence(importWith("[" + prediction(2, small) + "]"), 3,
                   "image_id 2 are of 2x2 pixels but the image has 32x24");
    test::writeFile(path("scene/seq-01/frame-000003.color.png"), "no image");
    expectSentence(import({"--strict"}), 3,
                   "seq-01/frame-000003.color.png cannot be used (colour image is damaged)");
    expectNothingWritten();
    expectSentence(test::runProgram("rgbd2rawlog",
                                    {"--format", "7scenes", "--input", path("missing"), "--check"}),
                   3, path("missing"));
}

TEST_F(Rgbd2Rawlog, noUsableFrameEndsWithFour)
{
    expectSentence(import({"--from", "100"}), 4, "none is selected");
    for (const char* n : {"0", "1", "2", "3"})
        fs::remove(path("scene/seq-01/frame-00000" + std::string(n) + ".pose.txt"));
    expectSentence(import(), 4, "no pose file");
    expectNothingWritten();
}

TEST_F(Rgbd2Rawlog, unwritableOutputEndsWithFive)
{
    expectSentence(test::runProgram("rgbd2rawlog", {"--format", "7scenes", "--input", path("scene"),
                                                    "--output", path("no/such/folder/k.rawlog")}),
                   5, "no/such/folder");
    fs::create_directory(path("k_Images"));
    expectSentence(import(), 5, "k_Images");
}

TEST_F(Rgbd2Rawlog, helpAndVersionSucceed)
{
    EXPECT_EQ(test::runProgram("rgbd2rawlog", {"--help"}).exitCode, 0);
    EXPECT_EQ(test::runProgram("rgbd2rawlog", {"--version"}).exitCode, 0);
}

TEST_F(Rgbd2Rawlog, stockMrptReadsARealRawlogWhole)
{
    SKIP_WITHOUT_REDKITCHEN();
    const auto result = test::runProgram(
        "rgbd2rawlog", {"--format", "7scenes", "--input", test::redkitchen().string(),
                        "--predictions", (test::redkitchen() / "predictions_coco.json").string(),
                        "--output", path("k.rawlog"), "--to", "29"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto info =
        test::runProgramIn(m_folder.path().string(), "rawlog-edit", {"--info", "-i", "k.rawlog"});
    if (info.exitCode == 127) GTEST_SKIP() << "no rawlog-edit on this machine";
    EXPECT_EQ(info.exitCode, 0);
    EXPECT_NE(info.output.find("Overall number of objects         : 61"), std::string::npos)
        << info.output;
    for (const char* label : {"RGBD", "pose"})  // newer MRPT has one more blank
        EXPECT_TRUE(
            std::regex_search(info.output, std::regex(std::string(label) + " +/ +30 +/ *30\\.000")))
            << label << " in\n"
            << info.output;
    EXPECT_NE(info.output.find("external storage directory: k_Images"), std::string::npos)
        << info.output;
}
