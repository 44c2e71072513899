// SPDX-License-Identifier: BSD-3-Clause
#include "Letterbox.h"

#include <gtest/gtest.h>

using namespace voxeland;

TEST(Letterbox, putsTheImageInTheMiddle)
{
    EXPECT_EQ(Letterbox({640, 480}, {640, 640}).content(), cv::Rect(0, 80, 640, 480));
    EXPECT_EQ(Letterbox({480, 640}, {640, 640}).content(), cv::Rect(80, 0, 480, 640));
    EXPECT_EQ(Letterbox({1280, 960}, {640, 640}).content(), cv::Rect(0, 80, 640, 480));
    EXPECT_EQ(Letterbox({100, 100}, {640, 320}).content(), cv::Rect(160, 0, 320, 320));
}

TEST(Letterbox, greyIsAroundTheImage)
{
    const cv::Mat image(2, 4, CV_8UC3, cv::Scalar(10, 20, 30));
    const cv::Mat input = Letterbox(image.size(), {8, 8}).fill(image);
    ASSERT_EQ(input.size(), cv::Size(8, 8));
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
            EXPECT_EQ(input.at<cv::Vec3b>(row, column),
                      row < 2 || row >= 6 ? cv::Vec3b(114, 114, 114) : cv::Vec3b(10, 20, 30));
}

TEST(Letterbox, boxesComeBackInPixelsOfTheImage)
{
    const Letterbox letterbox({1280, 960}, {640, 640});
    EXPECT_EQ(letterbox.toImage({10, 90, 20, 30}), cv::Rect2d(20, 20, 40, 60));
    EXPECT_EQ(letterbox.toImage({-10, 70, 20, 30}), cv::Rect2d(0, 0, 20, 40)) << "cut";
    EXPECT_TRUE(letterbox.toImage({10, 10, 20, 30}).empty()) << "in the grey";
}
