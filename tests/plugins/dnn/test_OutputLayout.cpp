// SPDX-License-Identifier: BSD-3-Clause
#include "OutputLayout.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
std::vector<NetworkOutput> outputs(const std::vector<std::vector<int>>& shapes)
{
    std::vector<NetworkOutput> result;
    for (const auto& shape : shapes)
        result.push_back({"o" + std::to_string(result.size()), cv::Mat(shape, CV_32F)});
    return result;
}

OutputLayout recognized(const std::vector<std::vector<int>>& shapes,
                        OutputLayout named = OutputLayout::automatic)
{
    return recognizeLayout(outputs(shapes), named);
}

int classes(const std::vector<std::vector<int>>& shapes)
{
    return numberOfClasses(recognized(shapes), outputs(shapes));
}

std::string errorOf(const std::vector<std::vector<int>>& shapes,
                    OutputLayout named = OutputLayout::automatic)
{
    try {
        recognized(shapes, named);
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}
}  // namespace

TEST(OutputLayout, isRecognizedFromTheShapes)
{
    EXPECT_EQ(recognized({{1, 25200, 117}, {1, 32, 160, 160}}), OutputLayout::yolov5);
    EXPECT_EQ(recognized({{1, 116, 8400}, {1, 32, 160, 160}}), OutputLayout::yolov8);
    EXPECT_EQ(recognized({{1, 32, 160, 160}, {1, 116, 8400}}), OutputLayout::yolov8);
    EXPECT_EQ(recognized({{1, 1, 100, 7}, {100, 90, 15, 15}}), OutputLayout::maskRcnn);
}

TEST(OutputLayout, anySizeOfInputAndAnyNumberOfClassesWillDo)
{
    EXPECT_EQ(classes({{1, 116, 8400}, {1, 32, 160, 160}}), 80);
    EXPECT_EQ(classes({{1, 25200, 117}, {1, 32, 160, 160}}), 80);
    EXPECT_EQ(classes({{1, 1, 100, 7}, {100, 90, 15, 15}}), 90);
    // An input of 320x192: 40x24 + 20x12 + 10x6 places. One class.
    EXPECT_EQ(classes({{1, 37, 1260}, {1, 32, 48, 80}}), 1);
    EXPECT_EQ(classes({{1, 3780, 38}, {1, 32, 48, 80}}), 1);
    // An input of 1280x1280 with a fourth grid, of 64 pixels.
    EXPECT_EQ(classes({{1, 102000, 117}, {1, 32, 320, 320}}), 80);
    // More channels than places: an input of 64x64 and 365 classes.
    EXPECT_EQ(classes({{1, 401, 84}, {1, 32, 16, 16}}), 365);
}

TEST(OutputLayout, aTurnedOneOfV8IsReadAsItIsMeant)
{
    EXPECT_EQ(recognized({{1, 8400, 116}, {1, 32, 160, 160}}), OutputLayout::yolov8);
    EXPECT_EQ(recognized({{1, 8400, 116}, {1, 32, 160, 160}}, OutputLayout::yolov8),
              OutputLayout::yolov8);
    EXPECT_EQ(recognized({{1, 8400, 117}, {1, 32, 160, 160}}, OutputLayout::yolov5),
              OutputLayout::yolov5)
        << "if that is what it is";
    EXPECT_EQ(classes({{1, 8400, 116}, {1, 32, 160, 160}}), 80);
    // 64x64 input, one place: a box of 20x10 at (30, 40), class 1 of 2, its mask's coefficient 3.
    std::vector<NetworkOutput> upright = outputs({{1, 7, 84}, {1, 1, 16, 16}});
    std::vector<NetworkOutput> turned = outputs({{1, 84, 7}, {1, 1, 16, 16}});
    for (auto* both : {&upright, &turned})
        for (auto& output : *both) output.tensor.setTo(0);
    const float values[] = {30, 40, 20, 10, 0.1F, 0.9F, 3};
    for (int v = 0; v < 7; ++v) {
        upright[0].tensor.at<float>(0, v, 5) = values[v];
        turned[0].tensor.at<float>(0, 5, v) = values[v];
    }
    for (auto* both : {&upright, &turned}) (*both)[1].tensor.setTo(1);
    const Letterbox letterbox({64, 64}, {64, 64});
    const auto a = decode(OutputLayout::yolov8, upright, letterbox, {});
    const auto b = decode(OutputLayout::yolov8, turned, letterbox, {});
    ASSERT_EQ(a.size(), 1U);
    ASSERT_EQ(b.size(), 1U);
    EXPECT_EQ(a[0].box, b[0].box);
    EXPECT_EQ(a[0].classScores, b[0].classScores);
    EXPECT_EQ(a[0].mask.toBitmap(), b[0].mask.toBitmap());
    EXPECT_FLOAT_EQ(static_cast<float>(b[0].score), 0.9F);
}

TEST(OutputLayout, theNamedOneIsUsedAsFarAsItCanBe)
{
    const std::vector<std::vector<int>> twoGrids = {{1, 116, 2000}, {1, 32, 160, 160}};
    EXPECT_NE(errorOf(twoGrids).find("no layout that is known"), std::string::npos);
    EXPECT_EQ(recognized(twoGrids, OutputLayout::yolov8), OutputLayout::yolov8);
    EXPECT_NE(errorOf(twoGrids, OutputLayout::maskRcnn).find("not the layout named"),
              std::string::npos);
    EXPECT_NE(errorOf({{1, 8400, 20}, {1, 32, 160, 160}}, OutputLayout::yolov5).find("not the"),
              std::string::npos)
        << "fewer channels than prototypes";
}

TEST(OutputLayout, anUnknownOneIsToldWithTheShapesFound)
{
    // A detector without masks, one that sorted out overlaps itself, a classifier.
    EXPECT_NE(errorOf({{1, 84, 8400}}).find("o0 1x84x8400,"), std::string::npos);
    EXPECT_NE(errorOf({{1, 84, 8400}}).find("for the task segment"), std::string::npos);
    EXPECT_NE(errorOf({{1, 300, 6}}).find("for the task segment"), std::string::npos);
    const std::string sorted = errorOf({{1, 300, 38}, {1, 32, 160, 160}});
    EXPECT_NE(sorted.find("o0 1x300x38, o1 1x32x160x160, which"), std::string::npos) << sorted;
    EXPECT_NE(sorted.find("nms=False end2end=False"), std::string::npos) << sorted;
    EXPECT_NE(errorOf({{1, 1000}}).find("o0 1x1000,"), std::string::npos);
}
