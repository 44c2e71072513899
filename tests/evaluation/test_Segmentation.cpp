// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"
#include "evaluation/Segmentation.h"

#include <gtest/gtest.h>

using namespace voxeland;
using voxeland::test::SceneBuilder;

TEST(SegmentationCounts, tellsSplitsFromMerges)
{
    const EvaluatedScene s =
        SceneBuilder()
            .object(0, 1000)  // in two pieces
            .object(0, 1000)  // merged with the next
            .object(1, 200)
            .object(1, 1000)         // a tenth bled into by its neighbour: over, no merge
            .object(NO_CLASS, 1000)  // under a tenth of it seen
            .object(0, 99)           // too small to count
            .instance(0, 500, 1)
            .instance(0, 400, 1)
            .instance(0, 1200, 1)
            .instance(1, 700, 1)
            .instance(1, 50, 1)
            .overlap(0, 0, 400)
            .overlap(0, 1, 300)
            .overlap(1, 2, 900)
            .overlap(2, 2, 150)
            .overlap(3, 0, 100)
            .overlap(3, 3, 600)
            .overlap(4, 3, 99)
            .overlap(5, 4, 50);
    const SegmentationCounts c = segmentationCounts({s}, {});
    EXPECT_EQ(c.objects, 5U);
    EXPECT_EQ(c.instances, 4U);
    EXPECT_EQ(c.coveredObjects, 4U);
    EXPECT_EQ(c.overSegmented, 2U);
    EXPECT_EQ(c.underSegmented, 1U);
    EXPECT_EQ(segmentationCounts({s, s}, {}).underSegmented, 2U);
}
