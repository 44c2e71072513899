// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"
#include "evaluation/InstanceVerdicts.h"

#include <gtest/gtest.h>

using namespace voxeland;
using voxeland::test::SceneBuilder;

TEST(CategoryVerdicts, judgeWhatLiesOnAnObjectWhateverItsClass)
{
    const EvaluatedScene s = SceneBuilder()
                                 .object(0, 1000)
                                 .object(1, 1000)
                                 .object(NO_CLASS, 1000)
                                 .instance(0, 150, 0.9)         // a small part of object 0: right
                                 .instance(0, 900, 0.8)         // on object 1: wrong
                                 .instance(NO_CLASS, 500, 0.7)  // neither has a class
                                 .instance(1, 400, 0.6)         // on an object without class: wrong
                                 .instance(1, 300, 0.5)  // a third on object 0, IoU too small
                                 .instance(0, 800, 0.4)  // less than half on 0, IoU > 0.25
                                 .instance(0, 99, 0.3)   // too small
                                 .overlap(0, 0, 140)
                                 .overlap(0, 4, 100)
                                 .overlap(0, 5, 390)
                                 .overlap(0, 6, 99)
                                 .overlap(1, 1, 900)
                                 .overlap(2, 2, 450)
                                 .overlap(2, 3, 380);
    const auto v = categoryVerdicts({s}, {});
    ASSERT_EQ(v.size(), 4U);
    const std::vector<std::pair<double, bool>> expected = {
        {0.9, true}, {0.8, false}, {0.6, false}, {0.4, true}};
    for (size_t i = 0; i < v.size(); ++i) {
        EXPECT_EQ(v[i].probability, expected[i].first);
        EXPECT_EQ(v[i].entropy, 1 - expected[i].first);
        EXPECT_EQ(v[i].correct, expected[i].second);
    }
}

TEST(DetectionVerdicts, anIouOfOneHalfIsEnough)
{
    const std::vector<EvaluatedScene> s = SceneBuilder()
                                              .object(0, 400)
                                              .object(0, 400)
                                              .object(1, 400)
                                              .instance(0, 200, 0.9)  // IoU 0.5: right
                                              .instance(0, 199, 0.8)  // IoU just below: wrong
                                              .instance(0, 400, 0.7)  // another class: wrong
                                              .instance(0, 300, 0.6)  // on void: ignored
                                              .instance(NO_CLASS, 300, 0.5)
                                              .overlap(0, 0, 200)
                                              .overlap(1, 1, 199)
                                              .overlap(2, 2, 400);
    const auto ignored = detectionVerdicts(s, {});
    ASSERT_EQ(ignored.size(), 3U);
    EXPECT_TRUE(ignored[0].correct);
    EXPECT_FALSE(ignored[1].correct);
    EXPECT_FALSE(ignored[2].correct);
    EvaluationProtocol strict;
    strict.voidPolicy = VoidPolicy::falsePositive;
    EXPECT_EQ(detectionVerdicts(s, strict).size(), 4U);
}

TEST(DetectionVerdicts, whatMatchesASmallObjectIsLeftOut)
{
    const std::vector<EvaluatedScene> s = SceneBuilder()
                                              .object(0, 90)
                                              .object(1, 400)
                                              .instance(0, 150, 0.9)
                                              .overlap(0, 0, 85)
                                              .overlap(1, 0, 65);
    EvaluationProtocol strict;
    strict.voidPolicy = VoidPolicy::falsePositive;
    EXPECT_TRUE(detectionVerdicts(s, strict).empty());
}
