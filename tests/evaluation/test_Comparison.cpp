// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/Comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace voxeland;

namespace
{
constexpr double VOXEL = 0.1;

/** A map of single voxels and a ground truth of single points. */
class Comparison : public testing::Test
{
 protected:
    Comparison() : map(optionsOf(VOXEL)) { truth.names = {"chair", "sofa", "plant"}; }

    static MapOptions optionsOf(double resolution)
    {
        MapOptions o;
        o.resolution = resolution;
        o.prior_strength = 0;
        return o;
    }
    instance_id_t addInstance(const std::string& category, double beta)
    {
        Instance& i = map.createInstance();
        i.categories.add(map.categories().add(category), beta);
        i.observations = 7;
        return i.id;
    }
    void addVoxel(const VoxelCoord& v, instance_id_t instance, float alpha = 1,
                  bool isOccupied = true)
    {
        map.addEvidence(v, instance, alpha);
        const OccupancyFilter& f = map.occupancyFilter();
        MapBlock& block = map.blocks().at(blockOf(v));
        block.setOccupancy(cellOf(v),
                           isOccupied ? f.afterHit(UNOBSERVED) : f.afterMiss(UNOBSERVED));
    }
    void addPoint(double x, double y, double z, uint32_t instance, uint32_t category)
    {
        truth.points.emplace_back(x, y, z);
        truth.instance.push_back(instance);
        truth.category.push_back(category);
    }
    [[nodiscard]] EvaluatedScene compared() const
    {
        return compare(map, truth, LabelMap::paper9(), protocol, "room");
    }

    SemanticVoxelMap map;
    GroundTruth truth;
    EvaluationProtocol protocol;
};
}  // namespace

TEST_F(Comparison, countsOverlapsOfKnownIoU)
{
    const instance_id_t chair = addInstance("chair", 3), couch = addInstance("couch", 1);
    // chair: voxels x = 0..5, couch: x = 6..9; one point in each voxel's middle, and two beyond
    for (int x = 0; x < 10; ++x) addVoxel({x, -1, 0}, x < 6 ? chair : couch);
    for (int x = 0; x < 12; ++x)  // object 5: x = 0..3, object 2: x = 4..11, of which 2 unseen
        addPoint((x + 0.5) * VOXEL, -0.05, 0.05, x < 4 ? 5 : 2, x < 4 ? 0 : 1);
    addPoint(0.05, -0.05, 0.05, 0, 2);  // a wall in the chair's first voxel
    const EvaluatedScene s = compared();
    ASSERT_EQ(s.objects.size(), 2U);
    EXPECT_EQ(s.objects[0].id, 2U);
    EXPECT_EQ(s.objects[0].category, "sofa");
    EXPECT_EQ(s.objects[0].points, 8U);
    EXPECT_EQ(s.objects[1].points, 4U);
    ASSERT_EQ(s.instances.size(), 2U);
    EXPECT_EQ(s.instances[0].category, "chair");
    EXPECT_EQ(s.instances[0].points, 7U) << "the wall's point included";
    EXPECT_EQ(s.instances[1].points, 4U);
    EXPECT_EQ(s.instances[1].cls, s.objects[0].cls);
    ASSERT_EQ(s.overlaps.size(), 3U);
    EXPECT_DOUBLE_EQ(iou(s, s.overlaps[0]), 2.0 / 13);  // object 2, chair
    EXPECT_DOUBLE_EQ(iou(s, s.overlaps[1]), 4.0 / 8);   // object 2, couch
    EXPECT_DOUBLE_EQ(iou(s, s.overlaps[2]), 4.0 / 7);   // object 5, chair
    EXPECT_EQ(voidPoints(s), (std::vector<size_t>{1, 0}));
}

TEST_F(Comparison, objectsHaveTheCategoryOfMostOfTheirPoints)
{
    for (int i = 0; i < 5; ++i) addPoint(0, 0, 0, 1, i < 2 ? 0 : 2);
    const EvaluatedScene s = compared();
    ASSERT_EQ(s.objects.size(), 1U);
    EXPECT_EQ(s.objects[0].category, "plant");
    EXPECT_EQ(s.objects[0].cls, NO_CLASS);
    EXPECT_EQ(s.objects[0].points, 5U);
}

TEST_F(Comparison, unknownWinnersAndFreeVoxelsGiveNone)
{
    const instance_id_t chair = addInstance("chair", 1);
    addVoxel({0, 0, 0}, chair);
    addVoxel({10, 0, 0}, chair, 1);
    addVoxel({10, 0, 0}, UNKNOWN_INSTANCE, 2);
    addVoxel({20, 0, 0}, chair, 1, false);
    addPoint(0.05, 0.05, 0.05, 1, 0);
    addPoint(1.05, 0.05, 0.05, 1, 0);
    addPoint(2.05, 0.05, 0.05, 1, 0);
    const EvaluatedScene s = compared();
    ASSERT_EQ(s.instances.size(), 1U);
    EXPECT_EQ(s.instances[0].points, 1U);
}

TEST_F(Comparison, reachIsThatOfAVoxelsCentre)
{
    const instance_id_t chair = addInstance("chair", 1);
    addVoxel({0, 0, 0}, chair);  // centre (0.05, 0.05, 0.05)
    EXPECT_NEAR(matchRadius(protocol, VOXEL), std::sqrt(3.0) / 2 * VOXEL, 1e-15);
    EXPECT_EQ(matchRadius(protocol, 0.02), 0.05);
    addPoint(0.136, 0.05, 0.05, 1, 0);  // 0.086 m away: within 0.0866
    addPoint(0.137, 0.05, 0.05, 1, 0);  // just beyond
    addPoint(-0.036, 0.05, 0.05, 1, 0);
    addPoint(-0.037, 0.05, 0.05, 1, 0);
    addPoint(5e7, 0, 0, 1, 0);  // where no voxel can be
    EXPECT_EQ(compared().instances[0].points, 2U);
    protocol.matchRadius = 0.3;
    addPoint(0.34, 0.05, 0.05, 1, 0);
    EXPECT_EQ(compared().instances[0].points, 5U);
}

TEST_F(Comparison, nearestVoxelAgreesWithBruteForce)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-0.9, 0.9);
    std::vector<std::pair<VoxelCoord, instance_id_t>> voxels;
    for (int i = 0; i < 60; ++i) {
        const VoxelCoord v =
            map.voxelOf(mrpt::math::TPoint3D(place(random), place(random), place(random)));
        if (map.evidence(v) != nullptr) continue;
        voxels.emplace_back(v, addInstance("chair", 1));
        addVoxel(v, voxels.back().second);
    }
    for (const double radius : {0.05, 0.12, 0.25}) {
        protocol.matchRadius = radius;
        for (int i = 0; i < 200; ++i) {
            truth.points.clear();
            truth.instance.clear();
            truth.category.clear();
            addPoint(place(random), place(random), place(random), 1, 0);
            const mrpt::math::TPoint3D p(truth.points[0]);
            instance_id_t expected = UNKNOWN_INSTANCE;
            double best = radius;
            for (const auto& [v, id] : voxels) {
                const double d = (voxelCenter<mrpt::math::TPoint3D>(v, VOXEL) - p).norm();
                if (v == map.voxelOf(p)) {
                    expected = id;
                    break;
                }
                if (d <= best) {
                    best = d;
                    expected = id;
                }
            }
            const EvaluatedScene s = compared();
            const auto taken = std::find_if(s.instances.begin(), s.instances.end(),
                                            [](const auto& x) { return x.points > 0; });
            ASSERT_EQ(taken == s.instances.end() ? UNKNOWN_INSTANCE : taken->id, expected);
        }
    }
}

TEST_F(Comparison, scoresAndEntropyComeFromTheMap)
{
    const instance_id_t chair = addInstance("chair", 10);
    map.instance(chair).categories.add(map.categories().add("sofa"), 1);
    map.categories().add("bed");
    addVoxel({0, 0, 0}, chair);
    addPoint(0.05, 0.05, 0.05, 1, 0);
    EXPECT_DOUBLE_EQ(compared().instances[0].score, 10.0 / 11);
    EXPECT_DOUBLE_EQ(compared().instances[0].probability, 10.0 / 11);
    EXPECT_NEAR(compared().instances[0].entropy, 0.2663, 5e-5);  // expected entropy of (10,1)
    protocol.score = ScoreKind::certainty;
    EXPECT_NEAR(compared().instances[0].score, 1 - 0.2663 / std::log(3.0), 5e-5);
    protocol.score = ScoreKind::observations;
    EXPECT_EQ(compared().instances[0].score, 7);
}

TEST_F(Comparison, pointsAreWrongWhereTheirInstanceStandsForAnotherObject)
{
    const instance_id_t chair = addInstance("chair", 1);
    for (int x = 0; x < 4; ++x) addVoxel({x, 0, 0}, chair, 10);
    const instance_id_t couch = addInstance("couch", 1);
    addVoxel({3, 0, 0}, couch, 1);  // the last voxel is disputed
    for (int x = 0; x < 3; ++x) addPoint((x + 0.5) * VOXEL, 0.05, 0.05, 1, 0);
    addPoint(0.35, 0.05, 0.05, 2, 1);
    addPoint(0.35, 0.05, 0.05, 0, 0);  // of no object
    addPoint(5.0, 0.05, 0.05, 2, 1);   // takes no instance
    const auto decisions = compared().pointDecisions;
    ASSERT_EQ(decisions.size(), 4U);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_FALSE(decisions[i].wrong);
        EXPECT_EQ(decisions[i].uncertainty, 0);
    }
    EXPECT_TRUE(decisions[3].wrong);
    EXPECT_NEAR(decisions[3].uncertainty, 0.2663, 5e-5);
    protocol.voidPolicy = VoidPolicy::falsePositive;
    ASSERT_EQ(compared().pointDecisions.size(), 5U);
    EXPECT_TRUE(compared().pointDecisions[4].wrong);
}
