// SPDX-License-Identifier: BSD-3-Clause
#include "base/timeText.h"

#include <gtest/gtest.h>

#include <thread>

using namespace voxeland;

namespace
{
/** How many of many times are told wrongly. */
int wrong(double seconds, const std::string& expected)
{
    int count = 0;
    for (int i = 0; i < 200000; ++i)
        if (timeText(mrpt::Clock::fromDouble(seconds)) != expected) ++count;
    return count;
}
}  // namespace

TEST(TimeText, IsOfItsOwnTimeInEachThread)
{
    int ofOther = 0;
    std::thread other([&] { ofOther = wrong(1e9, "2001/09/09,01:46:40.000000"); });
    EXPECT_EQ(wrong(0, "1970/01/01,00:00:00.000000"), 0);
    other.join();
    EXPECT_EQ(ofOther, 0);
}
