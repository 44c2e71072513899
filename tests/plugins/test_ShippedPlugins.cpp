// SPDX-License-Identifier: BSD-3-Clause
/** What the shipped plugins decide, on overlaps and frames made by hand. */
#include "support/ConfiguredPlugin.h"
#include "support/Frames.h"
#include "voxeland/plugins/CAssociationPolicy.h"
#include "voxeland/plugins/COpinionConverter.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
std::shared_ptr<CAssociationPolicy> evidential()
{
    return test::configuredPlugin<CAssociationPolicy>(
        "evidential_association", "CEvidentialAssociation",
        "tau_iou = 0.5\ntau_iov_strict = 0.8\ntau_iov_relaxed = 0.4\n"
        "tau_piece = 1\nablation = unclaimed\n");
}

std::shared_ptr<CAssociationPolicy> iouOnly(const std::string& keys = "tau_iou = 0.25\n")
{
    return test::configuredPlugin<CAssociationPolicy>("iou_association", "CIoUAssociation", keys);
}

/** Instances 1 (chair), 2 (chair, a little table) and 3 (table). */
SemanticVoxelMap threeInstances()
{
    SemanticVoxelMap map;
    const category_id_t chair = map.categories().add("chair"),
                        table = map.categories().add("table");
    map.createInstance().categories.add(chair, 1);
    Instance& second = map.createInstance();
    second.categories.add(chair, 2);
    second.categories.add(table, 1);
    map.createInstance().categories.add(table, 1);
    return map;
}

/** An overlap of which the map knew all but one voxel as that instance's. */
Overlap overlap(instance_id_t id, uint32_t common, uint32_t opinion, uint32_t instance,
                uint32_t visible, double similarity)
{
    Overlap o;
    o.instance = id;
    o.intersection = common;
    o.opinionVoxels = opinion;
    o.instanceVoxels = instance;
    o.visibleVoxels = visible;
    o.mappedVoxels = common + 1;
    o.similarity = similarity;
    return o;
}

OpinionOverlaps chairThatOverlaps(std::vector<Overlap> candidates)
{
    OpinionOverlaps overlaps;
    overlaps.categories.add(0, 0.9);
    overlaps.categories.add(1, 0.1);
    overlaps.candidates = std::move(candidates);
    return overlaps;
}

/** The instance a single opinion is given to. */
instance_id_t chosen(const CAssociationPolicy& policy, std::vector<Overlap> candidates)
{
    const auto map = threeInstances();
    const auto assignments = policy.associate({chairThatOverlaps(std::move(candidates))}, map);
    EXPECT_EQ(assignments.size(), 1u);
    return assignments.at(0).instance;
}
}  // namespace

TEST(Overlap, RatiosByHand)
{
    const Overlap o = overlap(1, 30, 40, 60, 50, 0);
    EXPECT_DOUBLE_EQ(o.iou(), 30. / 70);
    EXPECT_DOUBLE_EQ(o.iov(), 30. / 50);
    const InstanceOverlap two = {1, 2, 30, 40, 60, 0};
    EXPECT_DOUBLE_EQ(two.iou(), 30. / 70);
    EXPECT_DOUBLE_EQ(two.ios(), 30. / 40);
    const Overlap hidden = overlap(1, 30, 40, 60, 10, 0);
    EXPECT_LE(hidden.iov(), 1) << "what overlaps is visible";
}

TEST(EvidentialAssociation, MatchesByIntersectionOverUnion)
{
    const auto policy = evidential();
    EXPECT_EQ(chosen(*policy, {overlap(1, 60, 80, 90, 1000, 0)}), 1u);                // 60/110
    EXPECT_EQ(chosen(*policy, {overlap(1, 50, 80, 90, 1000, 0)}), UNKNOWN_INSTANCE);  // 50/120
    EXPECT_EQ(chosen(*policy, {}), UNKNOWN_INSTANCE);
}

TEST(EvidentialAssociation, TheVisibleShareNeededGoesLinearlyWithSimilarity)
{
    const auto policy = evidential();
    const auto matches = [&](uint32_t common, double similarity) {
        return chosen(*policy, {overlap(1, common, 120, 1000, 100, similarity)}) == 1;
    };
    EXPECT_FALSE(matches(79, 0.0));
    EXPECT_TRUE(matches(81, 0.0));
    EXPECT_FALSE(matches(59, 0.5));
    EXPECT_TRUE(matches(61, 0.5));
    EXPECT_FALSE(matches(39, 1.0));
    EXPECT_TRUE(matches(41, 1.0));
}

TEST(EvidentialAssociation, TheBestOfSeveralGetsIt)
{
    const auto policy = evidential();
    EXPECT_EQ(chosen(*policy, {overlap(1, 60, 100, 100, 100, 1), overlap(2, 90, 100, 100, 100, 1)}),
              2u);
    EXPECT_EQ(chosen(*policy, {overlap(1, 90, 100, 100, 100, 1), overlap(2, 60, 100, 100, 100, 1)}),
              1u);
}

TEST(EvidentialAssociation, UnmatchedOpinionsStartInstancesOfTheirOwn)
{
    const auto map = threeInstances();
    const auto assignments = evidential()->associate(
        {chairThatOverlaps({}), chairThatOverlaps({overlap(1, 90, 100, 100, 100, 1)}),
         chairThatOverlaps({})},
        map);
    ASSERT_EQ(assignments.size(), 3u);
    EXPECT_EQ(assignments[0].instance, UNKNOWN_INSTANCE);
    EXPECT_EQ(assignments[1].instance, 1u);
    EXPECT_EQ(assignments[2].instance, UNKNOWN_INSTANCE);
    EXPECT_NE(assignments[0].newInstance, assignments[2].newInstance);
}

TEST(IoUAssociation, NeedsTheSameMostProbableCategory)
{
    const auto policy = iouOnly();
    const Overlap table = overlap(3, 90, 100, 100, 100, 1),
                  chair = overlap(2, 50, 100, 100, 100, 0);
    EXPECT_EQ(chosen(*policy, {table}), UNKNOWN_INSTANCE);
    EXPECT_EQ(chosen(*policy, {chair, table}), 2u);
    const auto anyCategory = iouOnly("tau_iou = 0.25\nsame_category = false\n");
    EXPECT_EQ(chosen(*anyCategory, {chair, table}), 3u);
}

TEST(IoUAssociation, TakesTheGreatestIoUThatReachesTheThreshold)
{
    const auto policy = iouOnly();
    EXPECT_EQ(chosen(*policy, {overlap(1, 40, 100, 100, 40, 1)}), 1u);  // exactly 1/4
    EXPECT_EQ(chosen(*policy, {overlap(1, 39, 100, 100, 39, 1)}),
              UNKNOWN_INSTANCE);  // visible or not
    EXPECT_EQ(chosen(*policy, {overlap(1, 50, 100, 100, 1, 0), overlap(2, 60, 100, 100, 1, 0)}),
              2u);
}

TEST(IoUAssociation, InstancesWithoutCategoriesMatchNothing)
{
    SemanticVoxelMap map = threeInstances();
    const instance_id_t bare = map.createInstance().id;
    const auto policy = iouOnly();
    const auto assignments =
        policy->associate({chairThatOverlaps({overlap(bare, 90, 100, 100, 100, 0)})}, map);
    EXPECT_EQ(assignments.at(0).instance, UNKNOWN_INSTANCE);
    EXPECT_FALSE(policy->mayMerge({1, bare, 90, 100, 100, 0}, {}, map));
}

TEST(IoUAssociation, MergesByIntersectionOverUnionWithinACategory)
{
    const auto policy = iouOnly();
    const auto map = threeInstances();
    MergeThresholds thresholds;
    thresholds.iou = 0.25;
    EXPECT_TRUE(policy->mayMerge({1, 2, 41, 100, 100, 1}, thresholds, map));
    EXPECT_FALSE(policy->mayMerge({1, 2, 40, 100, 100, 1}, thresholds, map));
    EXPECT_FALSE(policy->mayMerge({1, 3, 99, 100, 100, 1}, thresholds, map));
}

TEST(EvidentialAssociation, MergesByGeometryAloneOrWithSimilarity)
{
    const auto policy = evidential();
    const auto map = threeInstances();
    const MergeThresholds thresholds = {0.8, true, 0.6, 0.7};
    const auto merges = [&](uint32_t common, uint32_t a, uint32_t b, double similarity) {
        return policy->mayMerge({1, 2, common, a, b, similarity}, thresholds, map);
    };
    EXPECT_TRUE(merges(90, 100, 100, 0));     // IoU 90/110
    EXPECT_FALSE(merges(88, 100, 100, 0));    // 88/112
    EXPECT_TRUE(merges(60, 100, 1000, 0.7));  // IoS 0.6
    EXPECT_FALSE(merges(59, 100, 1000, 0.7));
    EXPECT_FALSE(merges(60, 100, 1000, 0.69));
}

TEST(RecordedInstancesConverter, MakesAnOpinionOfEachUsablePrediction)
{
    const auto converter = test::configuredPlugin<COpinionConverter>(
        "recorded_instances", "CRecordedInstancesConverter", "min_score = 0.3\nmin_points = 50\n");
    RgbdFrame frame;
    frame.scan = test::makeScan([](int c, int) { return c < 20 ? 0.0 : 1.52; });
    auto predictions = test::makePredictions({
        test::prediction(test::rectangleMask(30, 10, 50, 30), "chair", 0.9F),
        test::prediction(test::rectangleMask(30, 10, 50, 30), "table", 0.2F),  // score
        test::prediction(test::rectangleMask(0, 0, 20, 60), "tv", 0.9F),       // no depth
        test::prediction(test::rectangleMask(30, 10, 37, 17), "cup", 0.9F),    // 49 points
        test::prediction(test::rectangleMask(60, 30, 70, 50), "nothing", 0.9F),
        test::prediction(test::rectangleMask(60, 10, 70, 30), "sofa", 0.3F),
    });
    predictions->instances[4].categories.clear();
    predictions->instances[5].track = 17;
    frame.instances = predictions;
    const auto opinions = converter->convert(frame, VoxelizedFrame(frame, 0.05, {}));
    ASSERT_EQ(opinions.size(), 2u);
    EXPECT_EQ(opinions[0].categories, (CategoryDistribution{{"chair", 1}}));
    EXPECT_EQ(opinions[0].confidence, 0.9F);
    EXPECT_EQ(opinions[0].track, InstancePrediction::NO_TRACK);
    float points = 0;
    for (const auto& v : opinions[0].voxels) points += v.points;
    EXPECT_EQ(points, 400);
    EXPECT_EQ(opinions[1].track, 17);

    frame.instances = nullptr;
    EXPECT_TRUE(converter->convert(frame, VoxelizedFrame(frame, 0.05, {})).empty());
}
