// SPDX-License-Identifier: BSD-3-Clause
/** Candidates, overlaps and masks of YOLO networks, on tensors made by hand. */
#include "YoloMasks.h"
#include "YoloV5.h"
#include "YoloV8.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;

namespace
{
/** A tensor of these sizes with all values 0. */
cv::Mat zeros(const std::vector<int>& sizes)
{
    return {sizes, CV_32F, cv::Scalar(0)};
}

YoloCandidate candidate(const cv::Rect2d& box, int category, float score)
{
    YoloCandidate c;
    c.box = box;
    c.topClass = category;
    c.score = score;
    return c;
}
}  // namespace

TEST(YoloV8, readsDownTheColumns)
{
    // Two classes, three prototypes, four places, of which the second and the last hold something.
    cv::Mat output = zeros({1, 4 + 2 + 3, 4});
    const std::vector<float> second = {100, 50, 20, 10, 0.25F, 0.5F, 1, -2, 3};
    const std::vector<float> last = {10, 20, 4, 4, 0.375F, 0.125F, 0, 0, 1};
    for (int row = 0; row < 9; ++row) {
        output.at<float>(0, row, 1) = second[static_cast<size_t>(row)];
        output.at<float>(0, row, 3) = last[static_cast<size_t>(row)];
    }
    const auto candidates = candidatesOfYoloV8(output, 3, 0.375);
    ASSERT_EQ(candidates.size(), 2u);
    EXPECT_EQ(candidates[0].box, cv::Rect2d(90, 45, 20, 10));
    EXPECT_EQ(candidates[0].topClass, 1);
    EXPECT_EQ(candidates[0].score, 0.5F);
    EXPECT_EQ(candidates[0].classScores, (ClassScores{0.25F, 0.5F}));
    EXPECT_EQ(candidates[0].coefficients, (std::vector<float>{1, -2, 3}));
    EXPECT_EQ(candidates[1].topClass, 0);
    EXPECT_EQ(candidatesOfYoloV8(output, 3, 0.4).size(), 1u);
}

TEST(YoloV5, readsAlongTheRowsAndMultipliesByTheObject)
{
    cv::Mat output = zeros({1, 3, 5 + 2 + 3});
    const std::vector<float> second = {100, 50, 20, 10, 0.5F, 0.25F, 0.75F, 1, -2, 3};
    std::copy(second.begin(), second.end(), output.ptr<float>(0, 1));
    const auto candidates = candidatesOfYoloV5(output, 3, 0.375);
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_EQ(candidates[0].box, cv::Rect2d(90, 45, 20, 10));
    EXPECT_EQ(candidates[0].topClass, 1);
    EXPECT_EQ(candidates[0].score, 0.375F);
    EXPECT_EQ(candidates[0].classScores, (ClassScores{0.125F, 0.375F}));
    EXPECT_EQ(candidates[0].coefficients, (std::vector<float>{1, -2, 3}));
    EXPECT_TRUE(candidatesOfYoloV5(output, 3, 0.376).empty());
}

TEST(YoloMasks, ofOverlappingBoxesOfAClassTheBestStays)
{
    // The second overlaps the first by 5/15, the third is of another class, the fourth is apart.
    const std::vector<YoloCandidate> all = {
        candidate({0, 0, 10, 10}, 0, 0.8F), candidate({5, 0, 10, 10}, 0, 0.9F),
        candidate({0, 0, 10, 10}, 1, 0.7F), candidate({50, 0, 10, 10}, 0, 0.6F)};
    const auto scores = [&](double maxOverlap) {
        std::vector<float> kept;
        for (const auto& c : withoutDuplicates(all, maxOverlap)) kept.push_back(c.score);
        return kept;
    };
    EXPECT_EQ(scores(0.34), (std::vector<float>{0.9F, 0.8F, 0.7F, 0.6F}));
    EXPECT_EQ(scores(0.33), (std::vector<float>{0.9F, 0.7F, 0.6F}));
}

TEST(YoloMasks, whatIsLeftOutLeavesNothingOut)
{
    // Each overlaps the one before by a half, and thus 1/3; the one in the middle goes.
    const auto kept =
        withoutDuplicates({candidate({0, 0, 10, 10}, 0, 0.9F), candidate({5, 0, 10, 10}, 0, 0.8F),
                           candidate({10, 0, 10, 10}, 0, 0.7F)},
                          0.3);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[1].score, 0.7F);
}

TEST(YoloMasks, aMaskIsTheWeightedSumOfPrototypesWithinTheBox)
{
    // Input of 16x16 for an image of 16x8; prototypes of 4x4: one is 1 in the left half and -1 in
    // the right one, the other 1 everywhere.
    cv::Mat prototypes = zeros({1, 2, 4, 4});
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            prototypes.at<float>(cv::Vec4i(0, 0, row, column)) = column < 2 ? 1.F : -1.F;
            prototypes.at<float>(cv::Vec4i(0, 1, row, column)) = 1;
        }
    const Letterbox letterbox({16, 8}, {16, 16});
    YoloCandidate c = candidate({0, 6, 12, 4}, 0, 0.5F);  // rows 2 to 5 of the image
    c.classScores = {0.5F};
    const auto boxOf = [&](std::vector<float> coefficients, double threshold) {
        c.coefficients = std::move(coefficients);
        return detectionOf(c, prototypes, letterbox, threshold).mask;
    };
    const RunLengthMask left = boxOf({1, 0}, 0.5), right = boxOf({-1, 0}, 0.5);
    EXPECT_EQ(left.width(), 16);
    EXPECT_EQ(left.height(), 8);
    const auto expectBox = [](const RunLengthMask& mask, int x, int y, int width, int height) {
        const PixelBox box = mask.boundingBox();
        EXPECT_EQ(box.x, x);
        EXPECT_EQ(box.y, y);
        EXPECT_EQ(box.width, width);
        EXPECT_EQ(box.height, height);
        EXPECT_EQ(mask.area(), static_cast<uint64_t>(width * height));
    };
    expectBox(left, 0, 2, 8, 4);
    expectBox(right, 8, 2, 4, 4);
    // A logit of 1 is a probability of 0.731.
    expectBox(boxOf({0, 1}, 0.73), 0, 2, 12, 4);
    EXPECT_TRUE(boxOf({0, 1}, 0.74).empty());
    const Detection d = detectionOf(c, prototypes, letterbox, 0.5);
    EXPECT_EQ(d.box, cv::Rect2d(0, 2, 12, 4));
    EXPECT_EQ(d.score, 0.5F);
    EXPECT_EQ(d.classScores, (ClassScores{0.5F}));
}

TEST(YoloMasks, pixelsBelongToABoxByTheirCentres)
{
    cv::Mat prototypes = zeros({1, 1, 4, 4});
    prototypes = cv::Scalar(1);
    YoloCandidate c = candidate({2.4, 3.6, 4.2, 5.2}, 0, 0.5F);  // to 6.6, 8.8
    c.coefficients = {1};
    const auto box =
        detectionOf(c, prototypes, Letterbox({16, 16}, {16, 16}), 0.5).mask.boundingBox();
    EXPECT_EQ(box.x, 2);
    EXPECT_EQ(box.y, 4);
    EXPECT_EQ(box.width, 5);
    EXPECT_EQ(box.height, 5);
}
