// SPDX-License-Identifier: BSD-3-Clause
#include "support/Frames.h"
#include "voxeland/observations/FrameAssembler.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

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
    return {patience, PoseTrack(MAX_GAP)};
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
    a.addPose(at(0), TPose3D(NAN, 0, 0, 0, 0, 0));
    addScan(a, 0);
    addInstances(a, 0);
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
