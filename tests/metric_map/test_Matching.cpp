// SPDX-License-Identifier: BSD-3-Clause
#include "support/HandMadeMap.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>

using namespace voxeland;
using mrpt::maps::CSimplePointsMap;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

namespace
{
/** Three occupied voxels, centres at (0.025, 0.025, 0.025), (1.025, 0.025, 0.025) and
 *  (0.025, 0.025, 1.025), and a free one. */
CVoxelandMap threeVoxels()
{
    CVoxelandMap map;
    test::setVoxel(map.editMap(), {0, 0, 0});
    test::setVoxel(map.editMap(), {20, 0, 0});
    test::setVoxel(map.editMap(), {0, 0, 20});
    test::setVoxel(map.editMap(), {-5, 0, 0}, 0.2);
    return map;
}

CSimplePointsMap pointsAt(const std::vector<mrpt::math::TPoint3Df>& points)
{
    CSimplePointsMap map;
    for (const auto& p : points) map.insertPoint(p.x, p.y, p.z);
    return map;
}

float ratio(const CVoxelandMap& map, const mrpt::maps::CMetricMap& other, float most,
            const CPose3D& pose = {})
{
    mrpt::maps::TMatchingRatioParams params;
    params.maxDistForCorr = most;
    return map.compute3DMatchingRatio(&other, pose, params);
}
}  // namespace

TEST(Matching, RatioIsTheShareOfPointsNearAVoxel)
{
    const CVoxelandMap map = threeVoxels();
    // 0.08 and 0.15 m from the first voxel's centre, 0.05 m from the second's, far from all.
    const auto points = pointsAt(
        {{0.105F, 0.025F, 0.025F}, {0.025F, 0.175F, 0.025F}, {1.025F, 0.025F, 0.075F}, {5, 5, 5}});
    EXPECT_FLOAT_EQ(ratio(map, points, 0.1F), 0.5F);
    EXPECT_FLOAT_EQ(ratio(map, points, 0.2F), 0.75F);
    EXPECT_FLOAT_EQ(ratio(map, points, 0.01F), 0);
    EXPECT_FLOAT_EQ(ratio(map, map, 0.01F), 1);
    EXPECT_FLOAT_EQ(ratio(map, map, 0.1F, CPose3D(1, 0, 0, 0, 0, 0)), 1 / 3.0F)
        << "moved by 1 m, the first voxel is where the second was";
    EXPECT_FLOAT_EQ(ratio(map, pointsAt({{1.075F, 0.025F, 0.025F}}), 0.1F), 1)
        << "outside of the box around the centres";
    EXPECT_FLOAT_EQ(ratio(map, CSimplePointsMap(), 1), 0);
    EXPECT_FLOAT_EQ(ratio(CVoxelandMap(), points, 1), 0);
}

TEST(Matching, OtherMapsMayBeSeveralOrPointless)
{
    const CVoxelandMap map = threeVoxels();
    mrpt::maps::CMultiMetricMap several;
    several.maps.push_back(std::make_shared<CVoxelandMap>(map));
    EXPECT_FLOAT_EQ(ratio(map, several, 0.1F), 1);
    EXPECT_FLOAT_EQ(several.compute3DMatchingRatio(&several, {}, {}), 1);
    EXPECT_THROW((void)ratio(map, mrpt::maps::COccupancyGridMap2D(), 1), std::runtime_error);
}

TEST(Matching, PointsArePairedInThreeDimensions)
{
    const CVoxelandMap map = threeVoxels();
    const auto points = pointsAt({{0.105F, 0.025F, 1.025F}, {3, 3, 3}});
    mrpt::tfest::TMatchingPairList pairs;
    mrpt::maps::TMatchingParams params;
    params.maxDistForCorrespondence = 0.1F;
    mrpt::maps::TMatchingExtraResults results;
    map.determineMatching3D(&points, CPose3D(), pairs, params, results);
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_NEAR(pairs[0].errorSquareAfterTransformation, 0.08 * 0.08, 1e-6);
    EXPECT_FLOAT_EQ(results.correspondencesRatio, 0.5F);
    const auto& known = *map.getAsSimplePointsMap();
    float x, y, z;
    known.getPointFast(pairs[0].globalIdx, x, y, z);
    EXPECT_NEAR(z, 1.025, 1e-6);
}

TEST(Matching, APlanarScanMeetsVoxelsOfItsHeightOnly)
{
    CVoxelandMap map = threeVoxels();
    for (const int z : {0, 20})  // CPointsMap wants boxes that touch
        for (const int xy : {-30, 30}) test::setVoxel(map.editMap(), {xy, xy, z});
    mrpt::maps::TMatchingParams params;
    params.maxDistForCorrespondence = 0.1F;
    const auto ratioAt = [&](float x, float z) {
        mrpt::tfest::TMatchingPairList pairs;
        mrpt::maps::TMatchingExtraResults results;
        const auto points = pointsAt({{x, 0.025F, z}});
        map.determineMatching2D(&points, CPose2D(1, 0, 0), pairs, params, results);
        for (const auto& pair : pairs) {
            mrpt::math::TPoint3Df voxel;
            map.getAsSimplePointsMap()->getPointFast(pair.globalIdx, voxel.x, voxel.y, voxel.z);
            EXPECT_NEAR(voxel.x, x + 1, 0.1) << "indices are those of all points";
            EXPECT_NEAR(voxel.z, z, 0.026);
        }
        return results.correspondencesRatio;
    };
    EXPECT_EQ(ratioAt(0.05F, 0.03F), 1) << "the second voxel, seen 1 m further";
    EXPECT_EQ(ratioAt(-0.95F, 1.02F), 1) << "the third voxel";
    EXPECT_EQ(ratioAt(0.05F, 1.02F), 0) << "above the second voxel there is nothing";
}

TEST(Matching, BoundingBoxHoldsOccupiedVoxelsWhole)
{
    const auto box = threeVoxels().boundingBox();
    EXPECT_NEAR(box.min.x, 0, 1e-6);
    EXPECT_NEAR(box.min.z, 0, 1e-6);
    EXPECT_NEAR(box.max.x, 1.05, 1e-6);
    EXPECT_NEAR(box.max.y, 0.05, 1e-6);
    EXPECT_NEAR(box.max.z, 1.05, 1e-6);
    const auto empty = CVoxelandMap().boundingBox();
    EXPECT_EQ(empty.min, empty.max);
}

TEST(Matching, APointOnTheFloorPlanHasNoDistance)
{
    EXPECT_THROW((void)threeVoxels().squareDistanceToClosestCorrespondence(0, 0), std::logic_error);
}
