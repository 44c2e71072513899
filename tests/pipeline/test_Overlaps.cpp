// SPDX-License-Identifier: BSD-3-Clause
/** The overlaps of opinions with instances against counting voxel by voxel. */
#include "HandMadeMap.h"
#include "support/Frames.h"
#include "voxeland/pipeline/Overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
constexpr double RESOLUTION = 0.05;

/** A wall with a step in it, and two opinions about overlapping parts of it. */
PreparedFrame steppedWall()
{
    RgbdFrame frame;
    frame.scan = makeScan([](int c, int) { return c < 40 ? 1.02 : 1.62; });
    VoxelizedFrame voxels(frame, RESOLUTION, {});
    auto space = castRays(voxels, 0.1);
    std::vector<Opinion> opinions(2);
    for (uint32_t h = 0; h < voxels.hits().size(); ++h) {
        if (h % 2 == 0) opinions[0].voxels.push_back({h, 1});
        if (h % 3 == 0) opinions[1].voxels.push_back({h, 1});
    }
    opinions[0].categories = {{"chair", 1}};
    opinions[1].categories = {{"table", 1}};
    return {std::move(voxels), std::move(opinions), std::move(space), true, {}};
}

/** Random evidence of five instances on and around what the frame hits, much of it hidden. */
SemanticVoxelMap randomMapAround(const PreparedFrame& frame)
{
    SemanticVoxelMap map = handMadeMap();
    for (int i = 0; i < 5; ++i) addInstance(map, i < 3 ? "chair" : "lamp");
    std::mt19937 random(11);
    const auto& hits = frame.voxels.hits();
    std::uniform_int_distribution<size_t> hit(0, hits.size() - 1);
    std::uniform_int_distribution<int32_t> step(-4, 4);
    std::uniform_int_distribution<instance_id_t> any(UNKNOWN_INSTANCE, 5);
    for (size_t i = 0; i < 3 * hits.size(); ++i) {
        const VoxelCoord aside = {step(random), 0, 0};
        const VoxelCoord at = hits[hit(random)].coord + aside;
        addBox(map, any(random), at, {1, 1, 1}, static_cast<float>(1 + i % 5));
    }
    return map;
}

/** A quarter of what speaks for instances makes a voxel part of one. */
bool isMember(const VoxelEvidence& evidence, instance_id_t id)
{
    float known = 0;
    for (const auto& e : evidence) known += e.instance == UNKNOWN_INSTANCE ? 0 : e.alpha;
    return evidence.alphaOf(id) > 0 && 4 * evidence.alphaOf(id) >= known;
}

bool isVisible(const ObservedSpace& space, const VoxelCoord& v)
{
    const ObservedBlock* block = space.find(blockOf(v));
    if (block == nullptr) return false;
    const int cell = cellOf(v);
    return block->hit.test(cell) || block->passed.test(cell) || block->behind.test(cell);
}
}  // namespace

TEST(OverlapFinder, CountsWhatBruteForceCounts)
{
    const PreparedFrame frame = steppedWall();
    SemanticVoxelMap map = randomMapAround(frame);
    OverlapFinder finder;
    (void)finder.find(frame, 1, map);  // nothing of one frame may be left for the next
    const auto found = finder.find(frame, 1, map);
    ASSERT_EQ(found.size(), 2U);
    uint32_t hidden = 0, outvoted = 0;
    for (size_t i = 0; i < found.size(); ++i) {
        const Opinion& opinion = frame.opinions[i];
        EXPECT_EQ(found[i].opinion, &opinion);
        ASSERT_EQ(found[i].candidates.size(), 5U);
        uint32_t mapped = 0;
        for (const OpinionVoxel& v : opinion.voxels)
            mapped += map.evidence(frame.voxels.hits()[v.hit].coord) != nullptr ? 1 : 0;
        EXPECT_LT(mapped, opinion.voxels.size());
        for (instance_id_t id = 1; id <= 5; ++id) {
            uint32_t common = 0, touched = 0, visible = 0, all = 0;
            for (const OpinionVoxel& v : opinion.voxels) {
                const auto* evidence = map.evidence(frame.voxels.hits()[v.hit].coord);
                if (evidence == nullptr) continue;
                common += isMember(*evidence, id) ? 1 : 0;
                touched += evidence->alphaOf(id) > 0 ? 1 : 0;
            }
            map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
                if (!isMember(evidence, id)) return;
                ++all;
                visible += isVisible(frame.space, v) ? 1 : 0;
            });
            const Overlap& o = found[i].candidates[id - 1];
            EXPECT_EQ(o.instance, id);
            EXPECT_EQ(o.intersection, common);
            EXPECT_EQ(o.opinionVoxels, opinion.voxels.size());
            EXPECT_EQ(o.instanceVoxels, all);
            EXPECT_EQ(o.visibleVoxels, visible);
            EXPECT_EQ(o.mappedVoxels, mapped);
            EXPECT_EQ(o.touchedVoxels, touched);
            outvoted += touched - common;
            EXPECT_NEAR(o.similarity, i == 0 && id <= 3 ? 1 : 0, 1e-9);
            hidden += all - visible;
        }
    }
    EXPECT_GT(hidden, 100U) << "the map must have something that the camera cannot see";
    EXPECT_GT(outvoted, 5U) << "instances must have evidence in voxels that others have";
}

TEST(OverlapFinder, InstancesInViewThatNoOpinionIsAboutWereMissed)
{
    PreparedFrame frame = steppedWall();
    frame.opinions.clear();
    SemanticVoxelMap map = handMadeMap();
    const auto& hits = frame.voxels.hits();
    const VoxelCoord outOfView = hits[0].coord + VoxelCoord{0, 0, -1000};
    // Of the first all is in view, of the second half, of the third a third.
    for (int hidden = 0; hidden < 3; ++hidden) {
        const instance_id_t id = addInstance(map, "chair");
        addBox(map, id, hits[static_cast<size_t>(10 * hidden)].coord, {1, 1, 1});
        addBox(map, id, outOfView + VoxelCoord{10 * hidden, 0, 0}, {hidden, 1, 1});
    }
    OverlapFinder finder;
    EXPECT_TRUE(finder.find(frame, 1, map).empty());
    using Ids = std::vector<instance_id_t>;
    EXPECT_EQ(finder.missed({}, 0.49, map), (Ids{1, 2}));
    EXPECT_EQ(finder.missed({}, 0.5, map), (Ids{1}));
    EXPECT_TRUE(finder.missed({}, 1, map).empty());
    EXPECT_EQ(finder.missed({}, 0.33, map), (Ids{1, 2, 3}));
    EXPECT_EQ(finder.missed({7, 1}, 0.49, map), (Ids{2}));
}

TEST(OverlapFinder, NewCategoriesGetNumbersAndAnEmptyMapHasNoCandidates)
{
    const PreparedFrame frame = steppedWall();
    SemanticVoxelMap map = handMadeMap();
    const auto found = OverlapFinder().find(frame, 1, map);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[0].candidates.empty());
    EXPECT_EQ(map.categories().names(), (std::vector<std::string>{"chair", "table"}));
    EXPECT_FLOAT_EQ(static_cast<float>(found[1].categories.betaOf(1)), 1);
}

TEST(OverlapFinder, ComparesCategoriesAsTheyCountAsEvidence)
{
    PreparedFrame frame = steppedWall();
    frame.opinions.resize(1);
    frame.opinions[0].categories = {{"chair", 0.75F}, {"sofa", 0.25F}};
    SemanticVoxelMap map = handMadeMap();
    const instance_id_t id = addInstance(map, "chair", 9);  // 0.75^2 : 0.25^2 = 9 : 1
    map.instance(id).categories.add(map.categories().add("sofa"), 1);
    map.addEvidence(frame.voxels.hits()[0].coord, id, 1);
    EXPECT_NEAR(OverlapFinder().find(frame, 2, map)[0].candidates.at(0).similarity, 1, 1e-6);
    EXPECT_LT(OverlapFinder().find(frame, 1, map)[0].candidates.at(0).similarity, 0.99);
}

TEST(OverlapFinder, CountsTheVoxelsThatOpinionsShare)
{
    const PreparedFrame frame = steppedWall();  // every second voxel, and every third
    SemanticVoxelMap map = handMadeMap();
    OverlapFinder finder;
    const auto opinions = finder.find(frame, 1, map);
    const auto hits = static_cast<uint32_t>(frame.voxels.hits().size());
    const uint32_t every6th = (hits + 5) / 6;
    EXPECT_EQ(opinions[0].shared, (std::vector<uint32_t>{0, every6th}));
    EXPECT_EQ(opinions[1].shared, (std::vector<uint32_t>{every6th, 0}));
    EXPECT_FALSE(lieApart(opinions, 0, 1)) << "they share a third of the smaller one";
}
