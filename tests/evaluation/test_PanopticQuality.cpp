// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"
#include "evaluation/PanopticQuality.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland;
using voxeland::test::SceneBuilder;

TEST(PanopticQuality, worksOutAsByHand)
{
    // object 0 found with IoU 150/250 = 0.6, object 1 with IoU 1, object 2 missed, instance 2 wrong
    const EvaluatedScene s = SceneBuilder()
                                 .object(0, 200)
                                 .object(0, 100)
                                 .object(0, 300)
                                 .object(1, 500)
                                 .instance(0, 200, 0.9)
                                 .instance(0, 100, 0.9)
                                 .instance(0, 120, 0.9)
                                 .overlap(0, 0, 150)
                                 .overlap(1, 1, 100)
                                 .overlap(3, 0, 50)
                                 .overlap(3, 2, 120);
    const PanopticQuality q = panopticQuality({s}, 0, {});
    EXPECT_EQ(q.matched, 2U);
    EXPECT_EQ(q.missedObjects, 1U);
    EXPECT_EQ(q.unmatchedInstances, 1U);
    EXPECT_DOUBLE_EQ(q.segmentation(), 0.8);
    EXPECT_DOUBLE_EQ(q.recognition(), 2.0 / 3);
    EXPECT_DOUBLE_EQ(q.quality(), 1.6 / 3);
    EXPECT_EQ(panopticQuality({s, s}, 0, {}).quality(), q.quality());
}

TEST(PanopticQuality, voidIsNotPartOfTheUnionUnlessItIsWrong)
{
    // 100 of 250 points on void: IoU 150/200 without them, 150/300 = 0.5 (no match) with them
    const std::vector<EvaluatedScene> s =
        SceneBuilder().object(0, 200).instance(0, 250, 0.9).overlap(0, 0, 150);
    EXPECT_DOUBLE_EQ(panopticQuality(s, 0, {}).segmentation(), 0.75);
    EvaluationProtocol strict;
    strict.voidPolicy = VoidPolicy::falsePositive;
    EXPECT_EQ(panopticQuality(s, 0, strict).matched, 0U);
    EXPECT_EQ(panopticQuality(s, 0, strict).unmatchedInstances, 1U);
}

TEST(PanopticQuality, instancesMostlyOnVoidOrOnSmallObjectsDoNotCount)
{
    const std::vector<EvaluatedScene> s =
        SceneBuilder().object(0, 90).instance(0, 150, 0.9).instance(0, 150, 0.9).overlap(0, 0, 90);
    const PanopticQuality q = panopticQuality(s, 0, {});
    EXPECT_EQ(q.matched + q.missedObjects + q.unmatchedInstances, 0U);
    EXPECT_TRUE(std::isnan(q.recognition()));
}
