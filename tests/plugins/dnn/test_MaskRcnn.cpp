// SPDX-License-Identifier: BSD-3-Clause
/** Detections of Mask R-CNN, on tensors made by hand. */
#include "MaskRcnn.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;

namespace
{
constexpr int CLASSES = 3, SIDE = 2;

/** Outputs for two objects: a first one of class 2 in the right half of the image, and a second
 * one of class 0 that reaches beyond its upper edge. */
struct Outputs
{
    cv::Mat boxes = cv::Mat(std::vector<int>{1, 1, 2, 7}, CV_32F, cv::Scalar(0));
    cv::Mat masks = cv::Mat(std::vector<int>{2, CLASSES, SIDE, SIDE}, CV_32F, cv::Scalar(0));

    Outputs()
    {
        setRow(0, {0, 2, 0.75F, 0.5F, 0, 1, 1});
        setRow(1, {0, 0, 0.5F, 0, -0.5F, 0.25F, 0.5F});
        setMask(0, 2, {1, 0, 1, 0});  // left half
        setMask(0, 1, {1, 1, 1, 1});  // of another class
        setMask(1, 0, {1, 1, 1, 1});
    }
    void setRow(int object, const std::vector<float>& values)
    {
        std::copy(values.begin(), values.end(), boxes.ptr<float>(0, 0) + object * 7);
    }
    void setMask(int object, int category, const std::vector<float>& values)
    {
        std::copy(values.begin(), values.end(), masks.ptr<float>(object, category));
    }
    [[nodiscard]] std::vector<Detection> detections(double score = 0.3) const
    {
        DetectionLimits limits;
        limits.score = score;
        return detectionsOfMaskRcnn(boxes, masks, {40, 20}, limits);
    }
};
}  // namespace

TEST(MaskRcnn, readsBoxesClassesAndScores)
{
    const auto detections = Outputs().detections();
    ASSERT_EQ(detections.size(), 2u);
    EXPECT_EQ(detections[0].box, cv::Rect2d(20, 0, 20, 20));
    EXPECT_EQ(detections[0].score, 0.75F);
    EXPECT_EQ(detections[0].classScores, (ClassScores{0, 0, 0.75F}));
    EXPECT_EQ(detections[1].box, cv::Rect2d(0, 0, 10, 10)) << "cut at the edge of the image";
    EXPECT_EQ(detections[1].classScores, (ClassScores{0.5F, 0, 0}));
    EXPECT_EQ(Outputs().detections(0.6).size(), 1u);
}

TEST(MaskRcnn, spreadsTheMaskOfTheClassOverTheBox)
{
    const auto detections = Outputs().detections();
    const PixelBox first = detections.at(0).mask.boundingBox();
    EXPECT_EQ(first.x, 20);
    EXPECT_EQ(first.width, 10);
    EXPECT_EQ(first.height, 20);
    EXPECT_EQ(detections[0].mask.area(), 200u);
    EXPECT_EQ(detections.at(1).mask.area(), 100u);
    EXPECT_EQ(detections[1].mask.boundingBox().height, 10);
}

TEST(MaskRcnn, passesOverRowsThatCannotBe)
{
    Outputs outputs;
    outputs.setRow(0, {0, 3, 0.75F, 0.5F, 0, 1, 1});           // no such class
    outputs.setRow(1, {0, 0, 0.5F, 0.5F, 0.5F, 0.25F, 0.5F});  // right of its left edge
    EXPECT_TRUE(outputs.detections().empty());
    outputs.setRow(0, {0, 1, NAN, 0.5F, 0, 1, 1});
    EXPECT_TRUE(outputs.detections().empty());
}
