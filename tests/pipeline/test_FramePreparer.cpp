// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FramePreparer.h"
#include "support/Frames.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>

#include <atomic>

using namespace voxeland;

namespace
{
constexpr int FRAMES = 40;

/** Frame number i has a wall at 1 + i/100 m and a mask that says "i"; `bad` lacks its depth. */
FramePreparer::Source source(std::atomic<int>& read, int bad = -1, int throwsAt = -1)
{
    return [&read, bad, throwsAt]() -> std::optional<RgbdFrame> {
        const int i = read++;
        if (i == throwsAt) throw InputError("the file is damaged");
        if (i >= FRAMES) return std::nullopt;
        const auto scan = test::makeScan([&](int, int) { return 1 + i / 100.0; }, i);
        scan->hasRangeImage = i != bad;
        return RgbdFrame{
            scan,
            test::makePredictions(
                {test::prediction(test::rectangleMask(10, 10, 60, 50), std::to_string(i))}, i),
            {}};
    };
}

class WithThreads : public ::testing::TestWithParam<unsigned>
{
 protected:
    SemanticMapper m_mapper{MapperConfig()};
    std::atomic<int> m_read{0};
};
}  // namespace

TEST_P(WithThreads, FramesComeInOrder)
{
    FramePreparer preparer(m_mapper, source(m_read), GetParam());
    for (int i = 0; i < FRAMES; ++i) {
        const auto frame = preparer.next();
        ASSERT_TRUE(frame);
        ASSERT_EQ(frame->opinions.size(), 1u);
        ASSERT_EQ(frame->opinions[0].categories[0].name, std::to_string(i));
        ASSERT_NEAR(frame->voxels.hits()[0].centroid.x, 1 + i / 100.0, 1e-4);
        ASSERT_LE(m_read, i + 1 + 2 * static_cast<int>(GetParam()) + 1) << "too far ahead";
    }
    EXPECT_FALSE(preparer.next());
    EXPECT_FALSE(preparer.next());
}

TEST_P(WithThreads, AnUnusableFrameIsReportedAfterThoseBefore)
{
    FramePreparer preparer(m_mapper, source(m_read, 7), GetParam());
    for (int i = 0; i < 7; ++i) ASSERT_TRUE(preparer.next()) << i;
    EXPECT_THROW(preparer.next(), UnusableFrame);
    for (int i = 8; i < FRAMES; ++i) ASSERT_TRUE(preparer.next()) << i;
    EXPECT_FALSE(preparer.next());
}

TEST_P(WithThreads, ADamagedFileIsReportedAfterTheFramesBefore)
{
    {
        FramePreparer preparer(m_mapper, source(m_read, -1, 9), GetParam());
        for (int i = 0; i < 9; ++i) ASSERT_TRUE(preparer.next()) << i;
        EXPECT_THROW(preparer.next(), InputError);
    }
    EXPECT_EQ(m_read, 10) << "what has failed is not asked again";
}

TEST_P(WithThreads, MayBeLeftBeforeTheEnd)
{
    {
        FramePreparer preparer(m_mapper, source(m_read), GetParam());
        EXPECT_TRUE(preparer.next());
    }
    EXPECT_LT(m_read, FRAMES);
    std::atomic<int> read{0};
    const FramePreparer untouched(m_mapper, source(read), GetParam());
}

INSTANTIATE_TEST_SUITE_P(FramePreparer, WithThreads, ::testing::Values(1u, 2u, 3u, 4u));
