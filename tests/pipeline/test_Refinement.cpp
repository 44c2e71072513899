// SPDX-License-Identifier: BSD-3-Clause
/** Division and merging of instances on maps made by hand. */
#include "HandMadeMap.h"
#include "pipeline/Refinement.h"
#include "support/MapBytes.h"
#include "support/Rooms.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace voxeland
{
/** Merges nothing, and remembers what it was asked. */
class CWitnessPolicy : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CWitnessPolicy, voxeland)

 public:
    [[nodiscard]] std::string description() const override { return "remembers pairs"; }
    void declareOptions(OptionList&) override {}
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>&,
                                                    const SemanticVoxelMap&) const override
    {
        return {};
    }
    [[nodiscard]] bool mayMerge(const InstanceOverlap& overlap, const MergeThresholds&,
                                const SemanticVoxelMap&) const override
    {
        m_asked.push_back(overlap);
        return false;
    }
    [[nodiscard]] const std::vector<InstanceOverlap>& asked() const { return m_asked; }

 private:
    mutable std::vector<InstanceOverlap> m_asked;
};
IMPLEMENTS_MRPT_OBJECT(CWitnessPolicy, voxeland::CAssociationPolicy, voxeland)
}  // namespace voxeland

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Refines by the paper's policy and says how often the map changed. */
MappingCounts refined(SemanticVoxelMap& map, const RefinementOptions& options,
                      uint32_t sinceFrame = 0)
{
    MappingCounts counts;
    refine(map, *evidentialPolicy(), options, sinceFrame, true, counts);
    return counts;
}

/** Boxes of 160 and 64 voxels that share 48: IoS 0.75, IoU 3/11. */
SemanticVoxelMap overlappingBoxes(const std::string& categoryA, const std::string& categoryB,
                                  uint32_t lastFrameOfA = 0)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t a = addInstance(map, categoryA, 2, lastFrameOfA);
    const instance_id_t b = addInstance(map, categoryB, 1, 0);
    addBox(map, a, {0, 0, 0}, {10, 4, 4});
    addBox(map, b, {7, 0, 0}, {4, 4, 4});
    return map;
}

/** Where instance 2 lies, instance 1 has a share as well, but what it wins lies elsewhere. */
SemanticVoxelMap sharedButApart()
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t a = addInstance(map, "chair"), b = addInstance(map, "chair");
    addBox(map, a, {0, 0, 0}, {5, 5, 5});
    addBox(map, a, {20, 0, 0}, {4, 4, 4}, 1);
    addBox(map, b, {20, 0, 0}, {4, 4, 4}, 2);
    return map;
}
}  // namespace

TEST(RefinementDivides, TwoCubesBecomeTwoInstancesWithTheirShareOfEvidence)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t old = addInstance(map, "chair", 6);
    const category_id_t sofa = map.categories().add("sofa");
    map.instance(old).categories.add(sofa, 2);
    addBox(map, old, {0, 0, 0}, {5, 5, 5}, 1);   // evidence 125
    addBox(map, old, {12, 0, 0}, {4, 4, 4}, 3);  // evidence 192
    const MappingCounts counts = refined(map, handMadeRefinement());
    EXPECT_EQ(counts.splits, 1U);
    EXPECT_EQ(counts.merges, 0U);
    ASSERT_EQ(map.instances().size(), 2U);
    const Instance& kept = map.instance(old);
    const Instance& divided = map.instances().rbegin()->second;
    EXPECT_EQ(kept.voxels, 125U) << "the part with more voxels keeps the number";
    EXPECT_EQ(divided.voxels, 64U);
    EXPECT_DOUBLE_EQ(evidenceOf(map, old), 125);
    EXPECT_DOUBLE_EQ(evidenceOf(map, divided.id), 192);
    const category_id_t chair = map.categories().add("chair");
    for (const auto& [category, beta] : {std::pair(chair, 6.0), std::pair(sofa, 2.0)}) {
        EXPECT_NEAR(divided.categories.sum().betaOf(category), beta * 192 / 317, 1e-12);
        EXPECT_NEAR(kept.categories.sum().betaOf(category), beta * 125 / 317, 1e-12);
    }
}

TEST(RefinementDivides, EachPartTakesItsShareOfWhatIsLeft)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t old = addInstance(map, "chair", 371);
    addBox(map, old, {0, 0, 0}, {5, 5, 5}, 1);   // evidence 125
    addBox(map, old, {12, 0, 0}, {4, 4, 4}, 3);  // evidence 192
    addBox(map, old, {0, 12, 0}, {3, 3, 3}, 2);  // evidence 54
    EXPECT_EQ(refined(map, handMadeRefinement()).splits, 2U);
    std::vector<double> beta;
    for (const auto& [id, instance] : map.instances())
        beta.push_back(instance.categories.sum().total());
    ASSERT_EQ(beta.size(), 3U);
    EXPECT_NEAR(beta[0], 125, 1e-9);
    EXPECT_NEAR(beta[1], 192, 1e-9);
    EXPECT_NEAR(beta[2], 54, 1e-9);
}

TEST(RefinementDivides, WhatIsFreeNowConnectsNothing)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t id = addInstance(map, "chair", 2);
    addBox(map, id, {0, 0, 0}, {16, 4, 4});
    EXPECT_EQ(refined(map, handMadeRefinement()).splits, 0U);
    for (int32_t x = 5; x < 11; ++x)
        for (int32_t y = 0; y < 4; ++y)
            for (int32_t z = 0; z < 4; ++z)
                map.blocks().at(blockOf({x, y, z})).setOccupancy(cellOf({x, y, z}), -1000);
    EXPECT_EQ(refined(map, handMadeRefinement()).splits, 1U);
}

TEST(RefinementDivides, OnlySizeableParts)
{
    const auto splits = [](const RefinementOptions& options) {
        SemanticVoxelMap map = handMadeMap();
        const instance_id_t id = addInstance(map, "chair", 9);
        addBox(map, id, {0, 0, 0}, {5, 5, 5});
        addBox(map, id, {12, 0, 0}, {3, 3, 3});
        addBox(map, id, {0, 12, 0}, {2, 2, 2});
        const MappingCounts counts = refined(map, options);
        double beta = 0;
        for (const auto& [number, instance] : map.instances())
            beta += instance.categories.sum().total();
        EXPECT_NEAR(beta, 9, 1e-12);
        EXPECT_EQ(map.instances().size(), counts.splits + 1);
        return counts.splits;
    };
    RefinementOptions options = handMadeRefinement();
    options.min_part_voxels = 8;
    options.min_part_share = 0.04;  // of 160 voxels
    EXPECT_EQ(splits(options), 2U);
    options.min_part_voxels = 9;
    EXPECT_EQ(splits(options), 1U);
    options.min_part_voxels = 28;
    EXPECT_EQ(splits(options), 0U);
    options.min_part_voxels = 8;
    options.min_part_share = 0.06;
    EXPECT_EQ(splits(options), 1U);
    options.split = false;
    EXPECT_EQ(splits(options), 0U);
}

TEST(RefinementMerges, WhatIsNearlyTheSamePlaceWhateverTheCategory)
{
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t a = addInstance(map, "chair", 2), b = addInstance(map, "sofa", 1);
    addBox(map, a, {0, 0, 0}, {10, 4, 4});
    addBox(map, b, {1, 0, 0}, {10, 4, 4});  // 144 shared of 176: IoU 0.818
    RefinementOptions options = handMadeRefinement();
    options.merge.iou = 0.82;
    EXPECT_EQ(refined(map, options).merges, 0U);
    options.merge.iou = 0.81;
    EXPECT_EQ(refined(map, options).merges, 1U);
    EXPECT_EQ(map.resolve(b), a) << "of equals the older one stays";
    EXPECT_EQ(map.instance(a).voxels, 176U);
    EXPECT_DOUBLE_EQ(map.instance(a).categories.sum().total(), 3);
}

TEST(RefinementMerges, PartsOfOneCategoryByOverlapOverSmaller)
{
    SemanticVoxelMap map = overlappingBoxes("chair", "chair");
    RefinementOptions options = handMadeRefinement();
    options.merge.ios = 0.76;
    EXPECT_EQ(refined(map, options).merges, 0U);
    options.merge.ios = 0.74;
    options.merge.use_ios = false;
    EXPECT_EQ(refined(map, options).merges, 0U);
    options.merge.use_ios = true;
    EXPECT_EQ(refined(map, options).merges, 1U);
    EXPECT_EQ(map.resolve(2), 1U) << "the larger one stays";
    EXPECT_EQ(map.instance(1).voxels, 176U);
    EXPECT_DOUBLE_EQ(evidenceOf(map, 1), 224);
    EXPECT_DOUBLE_EQ(map.instance(1).categories.sum().total(), 3);
}

TEST(RefinementMerges, NotWhatHasAnotherCategory)
{
    SemanticVoxelMap map = overlappingBoxes("table", "cup");
    const std::string before = bytesOf(map);
    EXPECT_EQ(refined(map, handMadeRefinement()).merges, 0U);
    EXPECT_EQ(bytesOf(map), before);
}

TEST(RefinementMerges, NotWhatIsNotConnected)
{
    SemanticVoxelMap map = sharedButApart();
    RefinementOptions options = handMadeRefinement();
    const std::string before = bytesOf(map);
    EXPECT_EQ(refined(map, options).merges, 0U);
    EXPECT_EQ(bytesOf(map), before);
    options.continuity = false;
    EXPECT_EQ(refined(map, options).merges, 1U);
    EXPECT_EQ(map.instance(1).voxels, 189U);
}

TEST(RefinementMerges, ScrapsOnlyWhereTheyTouch)
{
    // Both are in the voxels of a cube that *unknown* wins; each wins three voxels besides, too few
    // to be dense anywhere.
    const auto merges = [](int32_t apart) {
        SemanticVoxelMap map = handMadeMap();
        const instance_id_t a = addInstance(map, "chair"), b = addInstance(map, "chair");
        for (const instance_id_t id : {a, b}) addBox(map, id, {0, 0, 0}, {4, 4, 4});
        addBox(map, UNKNOWN_INSTANCE, {0, 0, 0}, {4, 4, 4}, 3);
        addBox(map, a, {0, 20, 0}, {3, 1, 1});
        addBox(map, b, {3 + apart, 20, 0}, {3, 1, 1});
        return refined(map, handMadeRefinement()).merges;
    };
    EXPECT_EQ(merges(0), 1U);
    EXPECT_EQ(merges(1), 1U) << "dbscan_eps is 2 voxels";
    EXPECT_EQ(merges(2), 0U);
    EXPECT_EQ(merges(100), 0U);
}

TEST(Refinement, TouchesNothingThatWasNotSeenLately)
{
    SemanticVoxelMap map = overlappingBoxes("chair", "chair");
    const instance_id_t fallenApart = addInstance(map, "sofa", 1, 4);
    addBox(map, fallenApart, {0, 40, 0}, {4, 4, 4});
    addBox(map, fallenApart, {0, 60, 0}, {4, 4, 4});
    const std::string before = bytesOf(map);
    const MappingCounts untouched = refined(map, handMadeRefinement(), 5);
    EXPECT_EQ(untouched.merges + untouched.splits, 0U);
    EXPECT_EQ(bytesOf(map), before);

    const MappingCounts lately = refined(map, handMadeRefinement(), 4);
    EXPECT_EQ(lately.splits, 1U);
    EXPECT_EQ(lately.merges, 0U);

    SemanticVoxelMap half = overlappingBoxes("chair", "chair", 7);
    EXPECT_EQ(refined(half, handMadeRefinement(), 7).merges, 1U) << "one of them was seen";
}

TEST(Refinement, OverlapsAreThoseOfBruteForce)
{
    SemanticVoxelMap map = handMadeMap();
    for (uint32_t i = 0; i < 6; ++i) addInstance(map, i % 2 == 0 ? "chair" : "table", 1, i);
    std::mt19937 random(5);
    std::uniform_int_distribution<int32_t> place(-6, 6);
    std::uniform_int_distribution<instance_id_t> any(UNKNOWN_INSTANCE, 6);
    for (int i = 0; i < 2000; ++i)
        addBox(map, any(random), {place(random), place(random), place(random) / 3}, {1, 1, 1},
               static_cast<float>(1 + i % 4));

    // Members of a voxel: at least a quarter of what speaks for instances there.
    std::map<instance_id_t, uint32_t> voxels;
    std::map<std::pair<instance_id_t, instance_id_t>, uint32_t> shared;
    map.forEachVoxel([&](const VoxelCoord&, log_odds_t, const VoxelEvidence& evidence) {
        float known = 0;
        for (const auto& e : evidence) known += e.instance == UNKNOWN_INSTANCE ? 0 : e.alpha;
        std::set<instance_id_t> members;
        for (const auto& e : evidence)
            if (e.instance != UNKNOWN_INSTANCE && 4 * e.alpha >= known) members.insert(e.instance);
        for (const instance_id_t a : members) {
            ++voxels[a];
            for (const instance_id_t b : members)
                if (a < b) ++shared[{a, b}];
        }
    });
    ASSERT_GT(shared.size(), 10U);

    constexpr uint32_t SINCE = 4;  // instances 5 and 6 were seen since
    RefinementOptions options = handMadeRefinement();
    options.split = false;
    const CWitnessPolicy witness;
    MappingCounts counts;
    refine(map, witness, options, SINCE, true, counts);
    size_t expected = 0;
    for (const auto& [pair, count] : shared) expected += pair.second > SINCE ? 1 : 0;
    EXPECT_EQ(witness.asked().size(), expected);
    double previous = 1;
    for (const InstanceOverlap& o : witness.asked()) {
        EXPECT_GT(o.b, SINCE);
        EXPECT_EQ(o.intersection, (shared[{o.a, o.b}]));
        EXPECT_EQ(o.voxelsA, voxels[o.a]);
        EXPECT_EQ(o.voxelsB, voxels[o.b]);
        EXPECT_NEAR(o.similarity, o.a % 2 == o.b % 2 ? 1 : 0, 1e-9);
        EXPECT_LE(o.ios(), previous) << "the most certain first";
        previous = o.ios();
    }
    EXPECT_EQ(counts.merges, 0U);
}

TEST(Deactivation, TakesTooLittleEvidenceAndTooLongOutOfSightTogether)
{
    SemanticVoxelMap map = handMadeMap();
    addBox(map, addInstance(map, "cup", 1.4, 9), {0, 0, 0}, {2, 2, 2});    // weak, long ago
    addBox(map, addInstance(map, "cup", 1.6, 9), {20, 0, 0}, {2, 2, 2});   // enough evidence
    addBox(map, addInstance(map, "cup", 1.4, 10), {40, 0, 0}, {2, 2, 2});  // within patience
    RefinementOptions options;
    options.min_evidence = 1.5;
    options.patience = 20;
    MappingCounts counts;
    counts.frames = 30;
    refine(map, *evidentialPolicy(), options, 0, true, counts);
    EXPECT_EQ(map.inactive(), std::set<instance_id_t>{1});
    EXPECT_EQ(map.instance(1).voxels, 8U) << "the record is kept";

    map.instance(1).categories.add(map.categories().add("cup"), 0.2);  // seen again
    refine(map, *evidentialPolicy(), options, 0, true, counts);
    EXPECT_TRUE(map.inactive().empty());
}

TEST(Deactivation, LooksAtWhatWasSeenLatelyAloneAndGivesTheSame)
{
    RefinementOptions options;
    options.min_evidence = 1.5;
    options.patience = 20;
    options.every = 10;
    SemanticVoxelMap lately = handMadeMap();
    for (uint32_t frame = 0; frame < 60; ++frame)
        addInstance(lately, "cup", frame % 2 == 0 ? 1.4 : 1.6, frame);
    SemanticVoxelMap all = lately;
    MappingCounts counts;
    for (counts.frames = 10; counts.frames <= 120; counts.frames += 10) {
        for (SemanticVoxelMap* map : {&lately, &all}) {
            if (counts.frames == 60) map->saw(3, 59);  // comes back
            const bool isFirst = map == &all || counts.frames == 10;
            refine(*map, *evidentialPolicy(), options, counts.frames - options.every, isFirst,
                   counts);
        }
        EXPECT_EQ(lately.inactive(), all.inactive()) << counts.frames;
    }
    EXPECT_EQ(all.inactive().size(), 30U);
}

TEST(RefinementOfManyRooms, LooksAtTheOneSeenLatelyAlone)
{
    constexpr int ROOMS = 200, PITCH = 6;
    constexpr uint32_t FRAMES = 10, SINCE = (ROOMS - 1) * FRAMES;
    SemanticVoxelMap room = overlappingBoxes("chair", "table");
    const instance_id_t fellApart = addInstance(room, "sofa");
    addBox(room, fellApart, {20, 0, 0}, {5, 5, 5});
    addBox(room, fellApart, {32, 0, 0}, {4, 4, 4});

    SemanticVoxelMap map = manyRooms(room, ROOMS, PITCH, FRAMES);
    const CWitnessPolicy witness;
    MappingCounts counts;
    counts.frames = ROOMS * FRAMES;
    refine(map, witness, handMadeRefinement(), SINCE, false, counts);
    EXPECT_EQ(counts.splits, 1U) << "of 200 that fell apart";
    ASSERT_EQ(witness.asked().size(), 1U) << "of 200 pairs";
    EXPECT_EQ(witness.asked().front().a, 3 * (ROOMS - 1) + 1U);
    EXPECT_EQ(map.instances().size(), 3U * ROOMS + 1);
}
