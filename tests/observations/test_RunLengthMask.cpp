// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/RunLengthMask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

using namespace voxeland;

namespace
{
std::vector<uint8_t> randomBitmap(std::mt19937& random, int width, int height)
{
    // Runs of random length, some longer than a row.
    std::vector<uint8_t> pixels;
    bool set = random() % 2 == 0;
    std::uniform_int_distribution<size_t> length(1, static_cast<size_t>(2 * width));
    const auto size = static_cast<size_t>(width * height);
    while (pixels.size() < size) {
        pixels.insert(pixels.end(), length(random), set ? 1 : 0);
        set = !set;
    }
    pixels.resize(size);
    return pixels;
}
}  // namespace

TEST(RunLengthMask, BitmapsReadBackAndAgreeWithBruteForce)
{
    std::mt19937 random(51);
    for (int run = 0; run < 300; ++run) {
        const int width = std::uniform_int_distribution<int>(1, 12)(random);
        const int height = std::uniform_int_distribution<int>(1, 12)(random);
        const auto pixels = randomBitmap(random, width, height);
        const auto mask = RunLengthMask::fromBitmap(pixels.data(), width, height);
        ASSERT_EQ(mask.toBitmap(), pixels);
        ASSERT_EQ(mask.area(), std::accumulate(pixels.begin(), pixels.end(), uint64_t{0}));
        ASSERT_EQ(mask, RunLengthMask(width, height, mask.runs()));

        int left = width, right = -1, top = height, bottom = -1;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (pixels[static_cast<size_t>(y * width + x)] != 0) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
        const PixelBox box = mask.boundingBox();
        if (right < 0) {
            ASSERT_TRUE(mask.empty());
            ASSERT_EQ(box.width, 0);
            ASSERT_EQ(box.height, 0);
            continue;
        }
        ASSERT_EQ(box.x, left);
        ASSERT_EQ(box.y, top);
        ASSERT_EQ(box.width, right - left + 1);
        ASSERT_EQ(box.height, bottom - top + 1);
    }
}

TEST(RunLengthMask, VisitsRunsOfSetPixels)
{
    const RunLengthMask mask(4, 3, {2, 3, 4, 0, 1, 2});
    std::vector<std::pair<uint32_t, uint32_t>> runs;
    mask.forEachRun([&](uint32_t first, uint32_t last) { runs.emplace_back(first, last); });
    EXPECT_EQ(runs, (std::vector<std::pair<uint32_t, uint32_t>>{{2, 5}, {10, 12}}));
    EXPECT_EQ(mask.area(), 5u);
}

TEST(RunLengthMask, AnyNonZeroByteIsSet)
{
    const std::vector<uint8_t> pixels = {0, 255, 7, 0};
    EXPECT_EQ(RunLengthMask::fromBitmap(pixels.data(), 2, 2).toBitmap(),
              (std::vector<uint8_t>{0, 1, 1, 0}));
}

TEST(RunLengthMask, RunsMustAddUpToTheImage)
{
    EXPECT_NO_THROW(RunLengthMask(4, 2, {8}));
    EXPECT_NO_THROW(RunLengthMask(4, 2, {0, 8}));
    EXPECT_NO_THROW(RunLengthMask(0, 0, {}));
    EXPECT_THROW(RunLengthMask(4, 2, {}), std::invalid_argument);
    EXPECT_THROW(RunLengthMask(4, 2, {3, 4}), std::invalid_argument);
    EXPECT_THROW(RunLengthMask(4, 2, {3, 6}), std::invalid_argument);
    EXPECT_THROW(RunLengthMask(-4, -2, {8}), std::invalid_argument);
    EXPECT_THROW(RunLengthMask(4, 2, {0xFFFFFFFFu, 9}), std::invalid_argument) << "wraps to 8";
}
