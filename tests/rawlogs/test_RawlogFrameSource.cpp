// SPDX-License-Identifier: BSD-3-Clause
/** Which predictions of a sidecar reach a frame, and which are counted as lost. */
#include "files/GzOutputFile.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/rawlogs/RawlogFrameSource.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <limits>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** What reading a rawlog gave. */
struct Read
{
    uint32_t frames = 0, withPredictions = 0, predictionsWithoutFrame = 0;
};

Read readAll(const std::string& file, const FrameRange& range, const InputOptions& options = {})
{
    RawlogFrameSource source(file, options, range);
    Read read;
    while (const auto frame = source.next()) {
        ++read.frames;
        read.withPredictions += frame->instances ? 1 : 0;
    }
    read.predictionsWithoutFrame = source.skipped().predictionsWithoutFrame;
    return read;
}

/** A rawlog of twelve moments, of which 0, 3, 4, 8 and 11 have predictions but no scan: the frames
 * are the moments 1 2 5 6 7 9 10. */
class SidecarWithGaps : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        auto frames = smallFrames(12);
        for (const size_t i : {0U, 3U, 4U, 8U, 11U}) frames[i].scan = nullptr;
        writeRawlog(m_file, frames);
    }

    TemporaryFolder m_folder;
    std::string m_file = m_folder.file("in.rawlog");
};
}  // namespace

TEST_F(SidecarWithGaps, PredictionsWithoutAFrameAreCounted)
{
    const Read all = readAll(m_file, {});
    EXPECT_EQ(all.frames, 7U);
    EXPECT_EQ(all.withPredictions, 7U);
    EXPECT_EQ(all.predictionsWithoutFrame, 5U);
}

TEST_F(SidecarWithGaps, PredictionsOfFramesLeftOutOnPurposeAreNot)
{
    const Read third = readAll(m_file, {0, UINT32_MAX, 3});
    EXPECT_EQ(third.frames, 3U);
    EXPECT_EQ(third.withPredictions, 3U);
    EXPECT_EQ(third.predictionsWithoutFrame, 5U);
}

TEST_F(SidecarWithGaps, TheCountsOfTwoPartsOfARunAddUp)
{
    for (uint32_t last = 0; last < 6; ++last) {
        const Read first = readAll(m_file, {0, last, 1});
        const Read second = readAll(m_file, {last + 1, UINT32_MAX, 1});
        EXPECT_EQ(first.frames, last + 1);
        EXPECT_EQ(second.frames, 6 - last);
        EXPECT_EQ(first.predictionsWithoutFrame + second.predictionsWithoutFrame, 5U) << last;
    }
    EXPECT_EQ(readAll(m_file, {2, 4, 1}).predictionsWithoutFrame, 2U) << "moments 3 and 4";
}

TEST(RawlogFrameSource, PredictionsOfAnotherRecordingAreToldWithTheirTimes)
{
    const TemporaryFolder folder;
    auto frames = smallFrames(3);
    for (SmallFrame& f : frames) f.instances->timestamp += std::chrono::hours(1);
    writeRawlog(folder.file("in.rawlog"), frames);
    RawlogFrameSource source(folder.file("in.rawlog"), {}, {});
    while (source.next()) continue;
    EXPECT_EQ(source.notes(), std::vector<std::string>{
                                  "predictions of 3 images in the file beside the rawlog belong to "
                                  "none of its frames: those are of 1000.000 to 1000.200 s, the "
                                  "predictions of 4600.000 to 4600.200 s"});
}

TEST(RawlogFrameSource, TakesOnlyTheSidecarsPredictionsOfTheSensorAskedFor)
{
    const TemporaryFolder folder;
    auto frames = smallFrames(6);
    for (size_t i = 0; i < frames.size(); ++i)
        frames[i].instances->sensorLabel = i % 3 == 0 ? "yolo" : "mask2former";
    frames[4].scan = nullptr;
    writeRawlog(folder.file("in.rawlog"), frames);
    InputOptions options;
    options.instances_sensor_label = "yolo";
    const Read yolo = readAll(folder.file("in.rawlog"), {}, options);
    EXPECT_EQ(yolo.frames, 5U);
    EXPECT_EQ(yolo.withPredictions, 2U);
    EXPECT_EQ(yolo.predictionsWithoutFrame, 0U);
}

/** Two sensors say where the robot is, a metre apart; which says it first changes on the way. */
TEST(RawlogFrameSource, PosesOfTwoSensorsAreNeverMixed)
{
    const TemporaryFolder folder;
    const auto frames = smallFrames(6);
    GzOutputFile out(folder.file("in.rawlog"));
    for (size_t i = 0; i < frames.size(); ++i) {
        frames[i].pose->sensorLabel = "wheels";
        frames[i].pose->pose.mean = mrpt::poses::CPose3D(0.1 * static_cast<double>(i), 0, 0);
        const auto other = mrpt::obs::CObservationRobotPose::Create(*frames[i].pose);
        other->sensorLabel = "gps";
        other->pose.mean.y(1);
        out.writeObject(i < 3 ? *frames[i].pose : *other);
        out.writeObject(i < 3 ? *other : *frames[i].pose);
        out.writeObject(*frames[i].scan);
    }
    out.close();
    for (const std::string wanted : {"", "wheels", "gps", "lidar"}) {
        InputOptions options;
        options.pose_sensor_label = wanted;
        RawlogFrameSource source(folder.file("in.rawlog"), options, {});
        uint32_t met = 0;
        for (; const auto frame = source.next(); ++met) {
            EXPECT_NEAR(frame->robotPose.x(), 0.1 * met, 1e-9) << wanted;
            EXPECT_EQ(frame->robotPose.y(), wanted == "gps" ? 1 : 0) << wanted;
        }
        EXPECT_EQ(met, wanted == "lidar" ? 0U : 6U) << wanted;
        if (wanted.empty()) {
            EXPECT_EQ(source.notes(),
                      std::vector<std::string>{"6 poses of 'gps' are left out, as those of "
                                               "'wheels' are used: choose with pose_sensor_label"});
        }
    }
}

TEST(RawlogFrameSource, PosesComeWithTheirCovariance)
{
    const TemporaryFolder folder;
    auto frames = smallFrames(2);
    for (int i = 0; i < 6; ++i) frames[1].pose->pose.cov(i, i) = 0.01 * (1 + i);
    writeRawlog(folder.file("in.rawlog"), frames);
    RawlogFrameSource source(folder.file("in.rawlog"), {}, {});
    EXPECT_EQ(source.next()->poseCovariance, nullptr) << "MRPT writes zeros where it knows none";
    const auto frame = source.next();
    ASSERT_NE(frame->poseCovariance, nullptr);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            EXPECT_NEAR((*frame->poseCovariance)(i, j), i == j ? 0.01 * (1 + i) : 0, 1e-9);
}

/** A robot whose position is measured by something 2 m ahead of its middle: where that is exact but
 *  the heading is not, the middle is uncertain to both sides. */
TEST(RawlogFrameSource, CovariancesAreOfTheRobotNotOfWhatMeasuresIt)
{
    const TemporaryFolder folder;
    auto frames = smallFrames(1);
    frames[0].pose->pose.mean = mrpt::poses::CPose3D(5, 6, 0, 0, 0, 0);
    frames[0].pose->sensorPose = mrpt::poses::CPose3D(2, 0, 0, 0, 0, 0);
    frames[0].pose->pose.cov(3, 3) = 0.01 * 0.01;
    writeRawlog(folder.file("in.rawlog"), frames);
    const auto frame = RawlogFrameSource(folder.file("in.rawlog"), {}, {}).next();
    EXPECT_NEAR(frame->robotPose.x(), 3, 1e-9);
    EXPECT_NEAR((*frame->poseCovariance)(0, 0), 0, 1e-9);
    EXPECT_NEAR((*frame->poseCovariance)(1, 1), 0.02 * 0.02, 1e-9);
    EXPECT_NEAR((*frame->poseCovariance)(3, 3), 0.01 * 0.01, 1e-9);
}

TEST(RawlogFrameSource, PosesOfASimplemapComeWithTheirCovariance)
{
    const TemporaryFolder folder;
    const auto frames = smallFrames(1);
    auto pose = mrpt::poses::CPose3DPDFGaussian::Create(frames[0].pose->pose);
    pose->cov(4, 4) = 0.25;
    auto sensed = mrpt::obs::CSensoryFrame::Create();
    sensed->insert(frames[0].scan);
    mrpt::maps::CSimpleMap map;
    map.insert(pose, sensed);
    GzOutputFile out(folder.file("in.simplemap"));
    out.writeObject(map);
    out.close();
    const auto frame = RawlogFrameSource(folder.file("in.simplemap"), {}, {}).next();
    ASSERT_TRUE(frame.has_value());
    ASSERT_NE(frame->poseCovariance, nullptr);
    EXPECT_EQ((*frame->poseCovariance)(4, 4), 0.25);
}

TEST_F(SidecarWithGaps, PredictionsOfImpossibleNumbersAreLeftOutAndTold)
{
    auto frames = smallFrames(4);
    frames[1].instances->instances[1].score = 1.5F;
    frames[2].instances->instances[0].score = std::nanf("");
    frames[2].instances->instances[1].score = -0.1F;
    frames[3].instances->instances[0].categories = {{"tv", std::numeric_limits<float>::infinity()}};
    for (const bool embed : {false, true}) {
        writeRawlog(m_file, frames, embed);
        if (embed) std::filesystem::remove(m_folder.file("in.instances.rawlog"));
        RawlogFrameSource source(m_file, {}, {});
        std::vector<size_t> predictions;
        while (const auto frame = source.next())
            predictions.push_back(frame->instances->instances.size());
        EXPECT_EQ(predictions, (std::vector<size_t>{2, 1, 0, 1}));
        ASSERT_EQ(source.notes().size(), 1U);
        EXPECT_EQ(source.notes().front().find(
                      "4 predictions of the rawlog left out (--strict: an error), "
                      "the first: prediction 2 of the image of "),
                  0U);
        EXPECT_NE(source.notes().front().find(" has a score of 1.5, which is not within 0 and 1"),
                  std::string::npos);
        RawlogFrameSource strict(m_file, {}, {}, true);
        EXPECT_THROW(while (strict.next()) continue, InputError);
    }
}
