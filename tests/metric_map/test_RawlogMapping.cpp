// SPDX-License-Identifier: BSD-3-Clause
/** Frames of a rawlog that cannot be mapped. */
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
class RawlogMapping : public ::testing::Test
{
 protected:
    MappedInput mapped(bool strict = false)
    {
        const std::string rawlog = m_folder.file("frames.rawlog");
        test::writeRawlog(rawlog, m_frames);
        RawlogFrameSource source(rawlog, m_map.mapper().config().input, {});
        return mapRawlog(
            source, m_map, [](const StageTimes&) {}, strict);
    }

    test::TemporaryFolder m_folder;
    std::vector<test::SmallFrame> m_frames = test::smallFrames(12);
    CVoxelandMap m_map;
};
}  // namespace

TEST_F(RawlogMapping, AFrameWithoutADepthImageIsLeftOut)
{
    m_frames[5].scan->hasRangeImage = false;
    m_frames[7].scan->rangeImage.setZero();
    const MappedInput met = mapped();
    EXPECT_EQ(met.leftOut.count(), 2U);
    EXPECT_NE(met.leftOut.first().find("has no depth image"), std::string::npos);
    EXPECT_EQ(m_map.counts().frames, 10U);
    EXPECT_THROW(mapped(true), InputError);
}

TEST_F(RawlogMapping, WithoutAUsableFrameNothingIsMapped)
{
    for (auto& frame : m_frames) frame.scan->rangeImage.setZero();
    EXPECT_THROW(mapped(), NothingToMapError);
    for (auto& frame : m_frames) frame.scan->hasRangeImage = false;
    EXPECT_THROW(mapped(), InputError);
}

TEST_F(RawlogMapping, AWrongUnitIsNoticedByTheDepths)
{
    const MappedInput right = mapped();
    EXPECT_GT(right.predictions, 0U);
    EXPECT_GT(right.opinions, 0U);
    for (const float factor : {0.001F, 100.0F}) {
        for (auto& frame : m_frames) frame.scan->rangeUnits = 0.001F * factor;
        try {
            mapped();
            ADD_FAILURE() << "no exception";
        } catch (const NothingToMapError& e) {
            const std::string text = e.what();
            EXPECT_NE(text.find("0.3 and 4 m"), std::string::npos) << text;
            EXPECT_NE(text.find("rangeUnits"), std::string::npos) << text;
        }
    }
}

TEST_F(RawlogMapping, FramesThatTheMapHoldsChangeNothing)
{
    mapped();
    const std::string once = test::bytesOf(m_map.map());
    EXPECT_EQ(mapped().repeated, m_frames.size());
    EXPECT_EQ(test::bytesOf(m_map.map()), once);
}
