// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/FrameAssembler.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/system/datetime.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace voxeland;
using mrpt::math::TPose3D;

namespace
{
constexpr double MAX_GAP = 0.25;

mrpt::Clock::time_point at(double seconds)
{
    return mrpt::Clock::fromDouble(seconds);
}

FrameAssembler assembler(uint32_t patience)
{
    return {patience, MAX_GAP};
}

void addScan(FrameAssembler& a, int second)
{
    a.addScan(test::makeScan([](int, int) { return 1.0; }, second));
}
void addInstances(FrameAssembler& a, int second)
{
    a.addInstances(test::makePredictions({}, second));
}
void addPose(FrameAssembler& a, int second)
{
    a.addPose(at(second), {static_cast<double>(second), 0, 0, 0, 0, 0});
}

std::vector<RgbdFrame> allOf(FrameAssembler& a)
{
    std::vector<RgbdFrame> frames;
    while (auto frame = a.next()) frames.push_back(std::move(*frame));
    return frames;
}

int secondOf(const RgbdFrame& frame)
{
    return static_cast<int>(std::lround(mrpt::Clock::toDouble(frame.scan->timestamp)));
}
}  // namespace

TEST(FrameAssembler, PartsMayComeInAnyOrder)
{
    std::vector<int> order = {0, 1, 2};
    do {
        auto a = assembler(5);
        for (const int part : order) {
            EXPECT_FALSE(a.next());
            if (part == 0) addScan(a, 7);
            if (part == 1) addInstances(a, 7);
            if (part == 2) addPose(a, 7);
        }
        const auto frame = a.next();
        ASSERT_TRUE(frame);
        EXPECT_TRUE(frame->instances);
        EXPECT_EQ(frame->robotPose.x(), 7);
        EXPECT_TRUE(a.empty());
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(FrameAssembler, MixedUpPartsOfManyFramesMakeTheSameFramesInOrderOfTheScans)
{
    std::mt19937 random(52);
    for (int run = 0; run < 50; ++run) {
        auto a = assembler(6);
        std::vector<RgbdFrame> frames;
        for (int second = 0; second < 40; second += 4) {  // parts of four frames, mixed
            std::vector<std::pair<int, int>> parts;
            for (int s = second; s < second + 4; ++s) {
                addScan(a, s);
                parts.insert(parts.end(), {{s, 1}, {s, 2}});
            }
            std::shuffle(parts.begin(), parts.end(), random);
            for (const auto& [s, kind] : parts) {
                if (kind == 1)
                    addInstances(a, s);
                else
                    addPose(a, s);
                for (auto& f : allOf(a)) frames.push_back(std::move(f));
            }
        }
        ASSERT_EQ(frames.size(), 40u);
        for (int s = 0; s < 40; ++s) {
            const auto& f = frames[static_cast<size_t>(s)];
            ASSERT_EQ(secondOf(f), s);
            ASSERT_TRUE(f.instances);
            ASSERT_EQ(f.instances->timestamp, f.scan->timestamp);
            ASSERT_EQ(f.robotPose.x(), s);
        }
        EXPECT_EQ(a.counts().framesWithoutPose, 0u);
        EXPECT_EQ(a.counts().predictionsWithoutFrame, 0u);
    }
}

TEST(FrameAssembler, WaitsForPredictionsWhileAFewNewerFramesCome)
{
    auto a = assembler(2);
    for (int s = 1; s <= 2; ++s) {
        addPose(a, s);
        addScan(a, s);
        EXPECT_FALSE(a.next()) << s;
    }
    addPose(a, 3);
    addScan(a, 3);
    const auto first = a.next();
    ASSERT_TRUE(first);
    EXPECT_EQ(secondOf(*first), 1);
    EXPECT_FALSE(first->instances);
    EXPECT_FALSE(a.next());
    addInstances(a, 2);
    const auto second = a.next();
    ASSERT_TRUE(second);
    EXPECT_TRUE(second->instances);
}

TEST(FrameAssembler, FramesWithoutAPoseAreSkippedAndCounted)
{
    auto a = assembler(1);
    for (int s = 1; s <= 4; ++s) {
        addScan(a, s);
        addInstances(a, s);
        if (s != 2) addPose(a, s);
    }
    a.addPose(at(5), TPose3D(NAN, 0, 0, 0, 0, 0));
    addScan(a, 5);
    a.finish();
    std::vector<int> seconds;
    for (const auto& f : allOf(a)) seconds.push_back(secondOf(f));
    EXPECT_EQ(seconds, (std::vector<int>{1, 3, 4}));
    EXPECT_EQ(a.counts().framesWithoutPose, 2u);
    EXPECT_EQ(a.counts().predictionsWithoutFrame, 0u);
    EXPECT_EQ(a.oddPoses().count(), 1u);
}

TEST(FrameAssembler, OddPosesAreErrorsIfStrict)
{
    FrameAssembler a(1, MAX_GAP, true);
    EXPECT_THROW(a.addPose(at(5), TPose3D(0, 0, 0, 0, INFINITY, 0)), InputError);
    EXPECT_THROW(a.addPose(INVALID_TIMESTAMP, TPose3D()), InputError);
    auto covariance = std::make_shared<mrpt::math::CMatrixDouble66>();
    covariance->setZero();
    (*covariance)(2, 3) = NAN;
    EXPECT_THROW(a.addPose(at(5), TPose3D(), covariance), InputError);
}

namespace
{
/** The x of each frame's pose, and the number of instances it has; -1: no predictions. */
std::vector<std::pair<double, int>> summaryOf(FrameAssembler& a)
{
    a.finish();
    std::vector<std::pair<double, int>> summary;
    for (const auto& f : allOf(a))
        summary.emplace_back(f.robotPose.x(),
                             f.instances ? static_cast<int>(f.instances->instances.size()) : -1);
    return summary;
}

/** Predictions that can be told from others by their number. */
std::shared_ptr<CObservationInstances> instances(double second, size_t count)
{
    return test::makePredictions(
        std::vector<InstancePrediction>(count,
                                        test::prediction(test::rectangleMask(0, 0, 2, 2), "box")),
        second);
}

std::shared_ptr<mrpt::obs::CObservation3DRangeScan> scanOf(double second)
{
    return test::makeScan([](int, int) { return 1.0; }, second);
}
}  // namespace

TEST(FrameAssembler, FramesOfTheSameTimeHaveTheirOwnPosesAndPredictions)
{
    for (const bool scanFirst : {false, true}) {
        auto a = assembler(5);
        for (size_t i = 0; i < 3; ++i) {
            if (scanFirst) a.addScan(scanOf(7));
            a.addPose(at(7), {static_cast<double>(i), 0, 0, 0, 0, 0});
            a.addInstances(instances(7, i));
            if (!scanFirst) a.addScan(scanOf(7));
        }
        EXPECT_EQ(summaryOf(a), (std::vector<std::pair<double, int>>{{0, 0}, {1, 1}, {2, 2}}));
    }
}

TEST(FrameAssembler, TwoScansOfOneTimeShareThePoseIfThereIsOne)
{
    auto a = assembler(5);
    a.addPose(at(7), {3, 0, 0, 0, 0, 0});
    a.addScan(scanOf(7));
    a.addScan(scanOf(7));
    EXPECT_EQ(summaryOf(a), (std::vector<std::pair<double, int>>{{3, -1}, {3, -1}}));
}

/** Two recordings of the same times, the second with poses 100 m away: however the parts of a frame
 *  are ordered, it gets its own; without any in the second one, its frames are left out. */
TEST(FrameAssembler, RecordingsOfTheSameTimesAreNotMixed)
{
    for (const double phase : {0.0, 0.03})  // of poses; interpolated unless 0
        for (const bool secondHasPoses : {true, false}) {
            auto a = assembler(5);
            std::vector<RgbdFrame> frames;
            for (const int recording : {0, 1})
                for (int i = 0; i < 8; ++i) {
                    const double x = 100 * recording;
                    a.addScan(scanOf(50 + 0.1 * i));
                    for (auto& f : allOf(a)) frames.push_back(std::move(f));
                    if (recording == 0 || secondHasPoses)
                        a.addPose(at(50 - phase + 0.1 * i), {x, 0, 0, 0, 0, 0});
                    if (i != 6) a.addInstances(instances(50 + 0.1 * i, recording));
                    for (auto& f : allOf(a)) frames.push_back(std::move(f));
                }
            a.finish();
            for (auto& f : allOf(a)) frames.push_back(std::move(f));
            // With poses between frames the last frame of a recording has none after it.
            const size_t ofOne = phase == 0 ? 8 : 7;
            ASSERT_EQ(frames.size(), secondHasPoses ? 2 * ofOne : ofOne);
            for (size_t i = 0; i < frames.size(); ++i) {
                const size_t recording = i / ofOne, number = i % ofOne;
                EXPECT_NEAR(frames[i].robotPose.x(), 100.0 * static_cast<double>(recording), 1e-6)
                    << i;
                ASSERT_EQ(frames[i].instances != nullptr, number != 6) << i;
                if (number != 6) {
                    EXPECT_EQ(frames[i].instances->instances.size(), recording) << i;
                }
            }
        }
}

TEST(FrameAssembler, PosesThatAllComeBeforeServeScansWhoseTimeGoesBack)
{
    auto a = assembler(3);
    for (int i = 0; i < 40; ++i) a.addPose(at(0.1 * i), {0.1 * i, 0, 0, 0, 0, 0});
    for (const double second : {2.0, 2.1, 2.2, 2.3, 2.4, 1.0, 1.1, 1.2}) a.addScan(scanOf(second));
    a.finish();
    const auto frames = allOf(a);
    ASSERT_EQ(frames.size(), 8u);
    for (const auto& f : frames)
        EXPECT_NEAR(f.robotPose.x(), mrpt::Clock::toDouble(f.scan->timestamp), 1e-6);
}

TEST(FrameAssembler, ATrajectorySurvivesTimesThatGoBack)
{
    auto a = assembler(0);
    PoseTrack trajectory(MAX_GAP);
    for (int s = 0; s < 100; ++s) trajectory.add(at(s), {static_cast<double>(s), 0, 0, 0, 0, 0});
    a.setTrajectory(trajectory);
    for (const int s : {60, 70, 80, 90, 5, 6}) a.addScan(scanOf(s));
    a.finish();
    std::vector<double> x;
    for (const auto& f : allOf(a)) x.push_back(f.robotPose.x());
    EXPECT_EQ(x, (std::vector<double>{60, 70, 80, 90, 5, 6}));
}

/** A camera 1 m ahead of a robot, looking to its left: where its optical axes are at (5, 6, 7), and
 *  z points along the world's y axis, x along the world's x axis, the robot is at (5 - 1, 6, 7). */
TEST(FrameAssembler, PosesMayBeOfTheCamerasAxes)
{
    using namespace mrpt::literals;
    const mrpt::poses::CPose3D ahead(1, 0, 0, 90.0_deg, 0.0_deg, 0.0_deg);
    // roll -90 degrees: x stays, y points down, z to the world's y; 90 degrees: y up, z to -y.
    for (const auto& [axes, roll] :
         {std::pair(PoseAxes::optical, -M_PI / 2), std::pair(PoseAxes::opengl, M_PI / 2)})
    {
        auto a = assembler(0);
        a.setPoseAxes(axes);
        auto covariance = std::make_shared<mrpt::math::CMatrixDouble66>();
        covariance->setZero();
        for (int i = 0; i < 3; ++i) (*covariance)(i, i) = 0.01 * (1 + i);
        a.addPose(at(1), {5, 6, 7, 0, 0, roll}, covariance);
        auto scan = scanOf(1);
        scan->sensorPose = ahead;
        a.addScan(scan);
        a.finish();
        const auto frame = a.next();
        ASSERT_TRUE(frame);
        EXPECT_NEAR(frame->robotPose.x(), 4, 1e-9);
        EXPECT_NEAR(frame->robotPose.y(), 6, 1e-9);
        EXPECT_NEAR(frame->robotPose.z(), 7, 1e-9);
        EXPECT_NEAR(frame->robotPose.yaw(), 0, 1e-9);
        EXPECT_NEAR(frame->robotPose.pitch(), 0, 1e-9);
        EXPECT_NEAR(frame->robotPose.roll(), 0, 1e-9);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR((*frame->poseCovariance)(i, i), 0.01 * (1 + i), 1e-9) << i;
    }
}

TEST(FrameAssembler, FinishGivesWhatIsLeftAndCountsPredictionsWithoutFrame)
{
    auto a = assembler(5);
    addPose(a, 1);
    addScan(a, 1);
    addInstances(a, 8);
    addInstances(a, 9);
    EXPECT_FALSE(a.next());
    a.finish();
    const auto frames = allOf(a);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_FALSE(frames[0].instances);
    EXPECT_EQ(a.counts().predictionsWithoutFrame, 2u);
    EXPECT_TRUE(a.empty());
}

TEST(FrameAssembler, PredictionsThatNoScanFollowsDoNotPileUp)
{
    auto a = assembler(3);
    constexpr uint32_t MANY = 100;
    for (uint32_t s = 1; s <= MANY; ++s) {
        addInstances(a, static_cast<int>(s));
        EXPECT_FALSE(a.next());
    }
    EXPECT_GE(a.counts().predictionsWithoutFrame, MANY - 10);
    addPose(a, MANY);
    addScan(a, MANY);
    const auto frame = a.next();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->instances) << "the newest are kept";
}

TEST(FrameAssembler, WhatWaitsIsSerializableWithLimitsAndCounts)
{
    auto a = assembler(5);
    a.addScan(scanOf(0), instances(0, 1), RobotPose{{NAN, 0, 0, 0, 0, 0}, nullptr});
    EXPECT_FALSE(a.next()) << "counted as being without a pose";
    addPose(a, 1);
    addScan(a, 1);
    addScan(a, 2);
    addInstances(a, 2);
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    a.writeTo(archive);
    stream.Seek(0);

    auto b = assembler(0);
    b.readFrom(archive);
    EXPECT_FALSE(b.empty());
    EXPECT_EQ(b.counts().framesWithoutPose, 1u);
    EXPECT_FALSE(b.next()) << "waits as long as the one written";
    addInstances(b, 1);
    addPose(b, 2);
    const auto frames = allOf(b);
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_TRUE(frames[0].instances);
    EXPECT_EQ(frames[0].robotPose.x(), 1);
    EXPECT_TRUE(frames[1].instances);
}

TEST(FrameAssembler, OfVeryManyPredictionsTheSurestAreUsed)
{
    std::vector<InstancePrediction> many;
    for (int i = 0; i < 1200; ++i)
        many.push_back(test::prediction(test::rectangleMask(0, 0, 9, 9), "cup",
                                        0.2F + 0.0005F * static_cast<float>(i)));
    auto a = assembler(5);
    addPose(a, 7);
    addScan(a, 7);
    a.addInstances(test::makePredictions(many, 7));
    const auto frame = a.next();
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->instances->instances.size(), 1000U);
    for (const auto& p : frame->instances->instances) EXPECT_GE(p.score, 0.2F + 0.0005F * 200);
    EXPECT_EQ(a.oddPredictions().count(), 1U);
    EXPECT_EQ(a.oddPredictions().first().find("of 1200 predictions"), 0U);
}
