// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FramePredictor.h"
#include "support/Frames.h"
#include "voxeland/base/errors.h"
#include "voxeland/observations/UnusableFrame.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace voxeland
{
/** Predicts an object named after the scan's second; fails at one of them. */
class CSecondsDetector : public COpinionConverter
{
    DEFINE_MRPT_OBJECT(CSecondsDetector, voxeland)

 public:
    [[nodiscard]] std::string description() const override { return "names the seconds"; }
    void declareOptions(OptionList&) override {}
    [[nodiscard]] bool makesPredictions() const override { return true; }
    [[nodiscard]] CObservationInstances::Ptr predict(
        const mrpt::obs::CObservation3DRangeScan& scan) const override
    {
        const auto second = std::lround(mrpt::Clock::toDouble(scan.timestamp));
        if (second == failsAt) throw InputError("cannot see");
        if (second == damagedAt) throw UnusableFrame("no such image");
        if (second == seesNothingAt) return nullptr;
        return test::makePredictions(
            {test::prediction(test::rectangleMask(10, 10, 60, 50), std::to_string(second))}, 0);
    }
    [[nodiscard]] std::vector<Opinion> convert(const RgbdFrame& frame,
                                               const VoxelizedFrame& voxels) const override
    {
        return opinionsOf(frame, voxels, {});
    }

    long failsAt = -1, damagedAt = -1, seesNothingAt = -1;
};
IMPLEMENTS_MRPT_OBJECT(CSecondsDetector, voxeland::COpinionConverter, voxeland)
}  // namespace voxeland

using namespace voxeland;

namespace
{
constexpr int FRAMES = 40;

class FramePredictorTest : public testing::Test
{
 protected:
    /** Frame number i is of second i, and has a recorded prediction. */
    [[nodiscard]] FramePreparer::Source source()
    {
        return [this]() -> std::optional<RgbdFrame> {
            const int i = m_read++;
            if (i >= FRAMES) return std::nullopt;
            RgbdFrame frame;
            frame.scan = test::makeScan([](int, int) { return 1.52; }, i);
            frame.instances = test::makePredictions(
                {test::prediction(test::rectangleMask(10, 10, 60, 50), "recorded")}, i);
            return frame;
        };
    }
    [[nodiscard]] SemanticMapper mapper() const
    {
        MapperConfig config;
        config.converter = m_detector;
        return SemanticMapper(config);
    }

    std::shared_ptr<CSecondsDetector> m_detector = std::make_shared<CSecondsDetector>();
    std::atomic<int> m_read{0};
};
}  // namespace

TEST_F(FramePredictorTest, everyFrameComesInOrderWithItsOwnPredictions)
{
    m_detector->seesNothingAt = 3;
    const SemanticMapper mapper = this->mapper();
    FramePredictor predictor(mapper, source());
    for (int i = 0; i < FRAMES; ++i) {
        const auto frame = predictor.next();
        ASSERT_TRUE(frame);
        ASSERT_EQ(frame->instances == nullptr, i == 3);
        if (i == 3) continue;
        EXPECT_EQ(frame->instances->instances.at(0).categories.at(0).name, std::to_string(i));
        EXPECT_EQ(frame->instances->timestamp, frame->scan->timestamp);
        EXPECT_EQ(frame->instances->sensorLabel, frame->scan->sensorLabel);
        EXPECT_GT(frame->detectionTime, 0);
        EXPECT_GT(mapper.prepare(*frame).times[static_cast<size_t>(Stage::detection)], 0);
    }
    EXPECT_FALSE(predictor.next());
    EXPECT_FALSE(predictor.next());
}

TEST_F(FramePredictorTest, itIsAheadButNotFar)
{
    const SemanticMapper mapper = this->mapper();
    FramePredictor predictor(mapper, source());
    ASSERT_TRUE(predictor.next());
    while (m_read < 5) std::this_thread::yield();  // without anybody asking for more
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(predictor.next());
    EXPECT_LE(m_read, 11 + 4 + 1);
}

TEST_F(FramePredictorTest, aFailureComesAfterTheFramesBefore)
{
    m_detector->failsAt = 7;
    const SemanticMapper mapper = this->mapper();
    FramePredictor predictor(mapper, source());
    for (int i = 0; i < 7; ++i) ASSERT_TRUE(predictor.next());
    EXPECT_THROW(predictor.next(), InputError);
    EXPECT_THROW(predictor.next(), InputError);
}

TEST_F(FramePredictorTest, aFrameThatCannotBeUsedIsToldAndTheNextOnesCome)
{
    m_detector->damagedAt = 7;
    const SemanticMapper mapper = this->mapper();
    for (const unsigned threads : {1U, 3U}) {
        m_read = 0;
        FramePredictor predictor(mapper, source());
        FramePreparer preparer(
            mapper, [&] { return predictor.next(); }, threads);
        for (int i = 0; i < 7; ++i) ASSERT_TRUE(preparer.next());
        EXPECT_THROW(preparer.next(), UnusableFrame);
        for (int i = 8; i < FRAMES; ++i) {
            const auto frame = preparer.next();
            ASSERT_TRUE(frame);
            EXPECT_EQ(frame->opinions.front().categories[0].name, std::to_string(i));
        }
        EXPECT_FALSE(preparer.next());
    }
}

TEST_F(FramePredictorTest, mayBeLeftBeforeTheEnd)
{
    const SemanticMapper mapper = this->mapper();
    {
        const FramePredictor untouched(mapper, source());
    }
    FramePredictor predictor(mapper, source());
    EXPECT_TRUE(predictor.next());
    EXPECT_LT(m_read, FRAMES);
}

TEST_F(FramePredictorTest, recordedPredictionsPassAsTheyAre)
{
    const SemanticMapper mapper{MapperConfig()};
    FramePredictor predictor(mapper, source());
    EXPECT_EQ(m_read, 0);
    const auto frame = predictor.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->instances->instances.at(0).categories.at(0).name, "recorded");
    EXPECT_EQ(frame->detectionTime, 0);
}
