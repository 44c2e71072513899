// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/CalibrationCheck.h"
#include "datasets/SevenScenesReader.h"
#include "support/Room.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

using namespace voxeland;
using test::Room;
using Verdict = CalibrationFinding::Verdict;

namespace
{
const PinholeCamera CAMERA = {60, 60, 39.5, 29.5, {}};

/** A walk through the room, written as 7-Scenes: depth in millimetres, camera-to-world poses. */
class CalibrationCheckTest : public testing::Test
{
 protected:
    void write(int frames, bool inverted = false, double scale = 1000)
    {
        for (int i = 0; i < frames; ++i) {
            const std::string stem = m_folder.file("frame-" + std::to_string(100000 + i));
            const auto pose = Room::cameraToWorld(i);
            test::writeImage(stem + ".color.png", test::greyImage(80, 60));
            test::writeImage(stem + ".depth.png", Room::depth(pose, CAMERA, 80, 60, scale));
            test::writeFile(stem + ".pose.txt",
                            test::matrixText(inverted ? Room::inverse(pose) : pose));
        }
    }
    [[nodiscard]] CalibrationFinding check(DatasetOptions options = {}) const
    {
        if (!options.camera) options.camera = CAMERA;
        const SevenScenesReader reader(m_folder.path().string(), options);
        return checkCalibration(reader, [](size_t) {});
    }
    static void expectSays(const CalibrationFinding& finding, const std::string& part)
    {
        EXPECT_NE(finding.sentence.find(part), std::string::npos) << finding.sentence;
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(CalibrationCheckTest, ConfirmsWhatIsRight)
{
    write(40);
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::consistent) << finding.sentence;
    EXPECT_LT(finding.asGiven.disagreement, 0.02);
    EXPECT_GT(finding.invertedPoses.disagreement, 0.1);
    EXPECT_GT(finding.asGiven.points, 1000U);
}

TEST_F(CalibrationCheckTest, FindsInvertedPoses)
{
    write(40, true);
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    EXPECT_TRUE(finding.best.invertPoses);
    EXPECT_EQ(finding.best.depthScale, finding.asGiven.depthScale);
    expectSays(finding, "--invert-poses");
    DatasetOptions mended;
    mended.invertPoses = true;
    EXPECT_EQ(check(mended).verdict, Verdict::consistent);
}

TEST_F(CalibrationCheckTest, FindsTheAxesOfThePoses)
{
    write(40);  // of optical axes
    for (const PoseAxes taken : {PoseAxes::opengl, PoseAxes::body}) {
        DatasetOptions options;
        options.poseAxes = taken;
        const auto finding = check(options);
        EXPECT_EQ(finding.verdict, Verdict::contradiction);
        EXPECT_EQ(finding.best.axes, PoseAxes::optical);
        EXPECT_FALSE(finding.best.invertPoses);
        expectSays(finding, "--pose-axes optical");
    }
}

TEST_F(CalibrationCheckTest, FindsAxesAndInversionTogether)
{
    write(40, true);
    DatasetOptions options;
    options.poseAxes = PoseAxes::opengl;
    const auto finding = check(options);
    EXPECT_EQ(finding.best.axes, PoseAxes::optical);
    EXPECT_TRUE(finding.best.invertPoses);
    expectSays(finding, "--pose-axes optical and add --invert-poses");
    options = DatasetOptions();
    options.invertPoses = true;
    EXPECT_EQ(check(options).verdict, Verdict::consistent);
}

TEST_F(CalibrationCheckTest, FindsAWrongDepthScale)
{
    write(40, false, 5000);
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    EXPECT_FALSE(finding.best.invertPoses);
    EXPECT_EQ(finding.best.depthScale, 5000);
    expectSays(finding, "--depth-scale 5000");
    DatasetOptions mended;
    mended.depthScale = 5000;
    EXPECT_EQ(check(mended).verdict, Verdict::consistent);
}

TEST_F(CalibrationCheckTest, FindsPosesInMillimetres)
{
    write(40);
    for (int i = 0; i < 40; ++i) {
        auto pose = Room::cameraToWorld(i);
        for (const size_t translation : {3U, 7U, 11U}) pose[translation] *= 1000;
        test::writeFile(m_folder.file("frame-" + std::to_string(100000 + i)) + ".pose.txt",
                        test::matrixText(pose));
    }
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    expectSays(finding, "1000 times as far apart");
    EXPECT_EQ(finding.sentence.find("--depth-scale"), std::string::npos) << finding.sentence;
}

TEST_F(CalibrationCheckTest, FindsBothAtOnce)
{
    write(40, true, 5000);
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    EXPECT_TRUE(finding.best.invertPoses);
    EXPECT_EQ(finding.best.depthScale, 5000);
}

TEST_F(CalibrationCheckTest, FindsAWrongFocalLength)
{
    write(40);
    DatasetOptions wrong;
    wrong.camera = CAMERA;
    wrong.camera->fx = wrong.camera->fy = 48;
    const auto finding = check(wrong);
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    EXPECT_EQ(finding.best.focalFactor, 1.25);  // 60 / 48
    expectSays(finding, "--intrinsics");
}

TEST_F(CalibrationCheckTest, TellsWhatItCannotTell)
{
    write(1);
    EXPECT_EQ(check().verdict, Verdict::nothing);
    for (int i = 0; i < 10; ++i) {  // the camera stands still
        const std::string stem = m_folder.file("frame-" + std::to_string(100000 + i));
        const auto pose = Room::cameraToWorld(0);
        test::writeImage(stem + ".color.png", test::greyImage(80, 60));
        test::writeImage(stem + ".depth.png", Room::depth(pose, CAMERA, 80, 60, 1000));
        test::writeFile(stem + ".pose.txt", test::matrixText(pose));
    }
    EXPECT_EQ(check().verdict, Verdict::nothing);
}

TEST_F(CalibrationCheckTest, CountsFramesThatCannotBeRead)
{
    write(40);
    for (int i = 0; i < 40; i += 2)
        std::filesystem::remove(
            m_folder.file("frame-" + std::to_string(100000 + i) + ".depth.png"));
    const auto finding = check();
    ASSERT_EQ(finding.unusable.count("no depth image"), 1U);
    EXPECT_EQ(finding.verdict, Verdict::consistent) << finding.sentence;
    EXPECT_NE(finding.text().find("of the frames read, no depth image\n"), std::string::npos)
        << finding.text();
}

TEST_F(CalibrationCheckTest, ALittleMotionDecidesNothing)
{
    write(4);
    EXPECT_EQ(check().verdict, Verdict::undecided);
}

TEST_F(CalibrationCheckTest, FindsPosesThatExplainNothing)
{
    write(40);
    for (int i = 0; i < 40; i += 2)  // every other pose is of another moment
        test::writeFile(m_folder.file("frame-" + std::to_string(100000 + i) + ".pose.txt"),
                        test::matrixText(Room::cameraToWorld((i * 7 + 20) % 40)));
    const auto finding = check();
    EXPECT_EQ(finding.verdict, Verdict::contradiction);
    expectSays(finding, "the intrinsics or the poses are wrong");
}

TEST_F(CalibrationCheckTest, TheRealKitchenHoldsTogether)
{
    SKIP_WITHOUT_REDKITCHEN();
    for (const bool inverted : {false, true}) {
        DatasetOptions options;
        options.invertPoses = inverted;
        const SevenScenesReader reader(test::redkitchen().string(), options);
        const auto finding = checkCalibration(reader, [](size_t) {});
        EXPECT_EQ(finding.verdict, inverted ? Verdict::contradiction : Verdict::consistent)
            << finding.sentence;
        EXPECT_EQ(finding.best.invertPoses, inverted);
        EXPECT_LT(finding.best.relative, 0.015);
    }
}
