// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MappedFrames.h"

#include <gtest/gtest.h>
#include <mrpt/system/datetime.h>

using namespace voxeland;

TEST(MappedFrames, AreKnownByTimeAndPlace)
{
    const auto time = mrpt::Clock::fromDouble(1e9), later = mrpt::Clock::fromDouble(1e9 + 1);
    MappedFrames frames;
    frames.add(time, {1, -2, 3});
    EXPECT_TRUE(frames.has(time, {1, -2, 3}));
    EXPECT_TRUE(frames.has(time, {1, -2, 3.00001})) << "the same but for rounding";
    EXPECT_FALSE(frames.has(later, {1, -2, 3}));
    EXPECT_FALSE(frames.has(time, {1, -2, 3.001})) << "another robot's frame of that time";
    EXPECT_FALSE(frames.has(time, {-2, 1, 3}));
    EXPECT_FALSE(frames.has(time, {1e300, -1e300, 0}));
}

TEST(MappedFrames, OfNoTimeAreNeverKnown)
{
    MappedFrames frames;
    frames.add(INVALID_TIMESTAMP, {1, 2, 3});
    EXPECT_FALSE(frames.has(INVALID_TIMESTAMP, {1, 2, 3}));
}

TEST(MappedFrames, AreRestored)
{
    MappedFrames frames;
    for (int i = 0; i < 100; ++i) frames.add(mrpt::Clock::fromDouble(i), {0.1 * i, 0, 0});
    const MappedFrames read = MappedFrames::restored(frames.sorted());
    EXPECT_EQ(read.sorted(), frames.sorted());
    EXPECT_EQ(read.sorted().size(), 100U);
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(read.has(mrpt::Clock::fromDouble(i), {0.1 * i, 0, 0}));
}
