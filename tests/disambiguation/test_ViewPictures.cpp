// SPDX-License-Identifier: BSD-3-Clause
#include "disambiguation/ViewPictures.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

using namespace voxeland;

namespace
{
constexpr int COUNT = 8;

/** Frames whose images are grey with the object of the first prediction in yellow. */
std::vector<test::SmallFrame> colourFrames(int columns = test::COLUMNS, int shift = 0)
{
    auto frames = test::smallFrames(COUNT);
    for (auto& f : frames) {
        cv::Mat image(test::ROWS, columns, CV_8UC3, cv::Scalar(90, 90, 90));
        auto& prediction = f.instances->instances[0];
        const PixelBox box = prediction.mask.boundingBox();
        image(cv::Rect(box.x, box.y, box.width, box.height) & cv::Rect(0, 0, columns, test::ROWS)) =
            cv::Scalar(0, 200, 200);
        f.scan->intensityImage = mrpt::img::CImage(image, mrpt::img::DEEP_COPY);
        f.scan->hasIntensityImage = true;
        f.scan->cameraParamsIntensity = f.scan->cameraParams;
        if (shift != 0)
            prediction.mask =
                test::rectangleMask(box.x, box.y, box.x + box.width + shift, box.y + box.height);
    }
    return frames;
}

/** The views that a map of those frames would remember of the first prediction. */
std::vector<UncertainInstance> viewsOf(const std::vector<test::SmallFrame>& frames)
{
    UncertainInstance u;
    u.id = 1;
    for (const auto& f : frames) {
        CandidateView v;
        v.view.time = f.scan->timestamp;
        const ImageRegion region = regionOf(f.instances->instances[0].mask);
        v.view.box = region.box;
        v.view.area = region.area;
        u.views.push_back(v);
    }
    return {u};
}

struct ViewPictures : testing::Test
{
    test::TemporaryFolder folder;
    std::string rawlog = folder.file("small.rawlog");
    MapperConfig config;

    size_t fetch(std::vector<UncertainInstance>& instances)
    {
        return fetchPictures(instances, rawlog, config, [](double) {});
    }
    std::string refusal(std::vector<UncertainInstance> instances)
    {
        try {
            fetch(instances);
        } catch (const InputError& e) {
            return e.what();
        }
        return "accepted";
    }
};

cv::Mat decoded(const std::string& bytes)
{
    return cv::imdecode(std::vector<uchar>(bytes.begin(), bytes.end()), cv::IMREAD_COLOR);
}
}  // namespace

TEST_F(ViewPictures, ShowTheObjectOutlinedWithAMargin)
{
    config.disambiguation.crop_margin = 0.5;  // 10 of 20 pixels
    config.disambiguation.picture_size = 160;
    config.disambiguation.whole_frame = true;
    for (const bool embed : {false, true}) {
        const auto frames = colourFrames();
        test::writeRawlog(rawlog, frames, embed);
        auto instances = viewsOf(frames);
        EXPECT_EQ(fetch(instances), 0U);
        for (const CandidateView& v : instances[0].views) {
            const cv::Mat crop = decoded(v.picture);
            EXPECT_EQ(crop.size(), cv::Size(160, 160)) << "40 pixels, four times larger";
            const auto near = [&](int row, int column, const cv::Scalar& colour) {
                const auto p = crop.at<cv::Vec3b>(row, column);
                return cv::norm(cv::Scalar(p[0], p[1], p[2]), colour) < 40;
            };
            EXPECT_TRUE(near(80, 80, {0, 200, 200})) << "the object is in the middle";
            EXPECT_TRUE(near(15, 80, {90, 90, 90})) << "the margin is around it";
            double brightest = 0;
            for (int row = 36; row < 48; ++row)
                brightest = std::max(brightest, double{crop.at<cv::Vec3b>(row, 80)[0] * 1.0});
            EXPECT_GT(brightest, 200) << "its outline is white";
        }
        EXPECT_EQ(decoded(instances[0].views[0].wholeFrame).size(),
                  cv::Size(test::COLUMNS, test::ROWS));
    }
}

TEST_F(ViewPictures, MissingFramesAreCounted)
{
    auto frames = colourFrames();
    auto instances = viewsOf(frames);
    frames.resize(COUNT - 3);
    test::writeRawlog(rawlog, frames);
    EXPECT_EQ(fetch(instances), 3U);
    EXPECT_FALSE(instances[0].views.front().picture.empty());
    EXPECT_TRUE(instances[0].views.back().picture.empty());
}

TEST_F(ViewPictures, AnotherRawlogIsNoticed)
{
    const auto views = viewsOf(colourFrames());
    auto later = colourFrames();
    for (auto& f : later) f.scan->timestamp = f.instances->timestamp += std::chrono::hours(1);
    test::writeRawlog(rawlog, later);
    EXPECT_NE(refusal(views).find("none of the frames"), std::string::npos);

    test::writeRawlog(rawlog, colourFrames(40));
    EXPECT_NE(refusal(views).find("another size"), std::string::npos);

    test::writeRawlog(rawlog, colourFrames(test::COLUMNS, -1));
    EXPECT_NE(refusal(views).find("predictions"), std::string::npos);

    test::writeRawlog(rawlog, test::smallFrames(COUNT));
    EXPECT_NE(refusal(views).find("colour"), std::string::npos);
}

TEST(Sharpness, FallsWithBlurAndNotWithContrast)
{
    cv::Mat board(128, 128, CV_8UC3);
    for (int r = 0; r < board.rows; ++r)
        for (int c = 0; c < board.cols; ++c)
            board.at<cv::Vec3b>(r, c) =
                (r / 16 + c / 16) % 2 == 0 ? cv::Vec3b(200, 200, 200) : cv::Vec3b(50, 50, 50);
    cv::Mat blurred, faint;
    cv::blur(board, blurred, {5, 5});
    board.convertTo(faint, CV_8U, 0.5);
    EXPECT_LT(sharpnessOf(blurred), 0.5F * sharpnessOf(board));
    EXPECT_NEAR(sharpnessOf(faint), sharpnessOf(board), 0.02F * sharpnessOf(board));
    EXPECT_EQ(sharpnessOf(cv::Mat(9, 9, CV_8UC3, cv::Scalar::all(7))), 0);
}
