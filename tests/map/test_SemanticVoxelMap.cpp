// SPDX-License-Identifier: BSD-3-Clause
#include "MapBuilding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

using namespace voxeland;
using voxeland::test::changeAtRandom;
using voxeland::test::voxelsOf;

namespace
{
double evidenceInVoxels(const SemanticVoxelMap& map)
{
    double total = 0;
    map.forEachVoxel([&](const VoxelCoord&, log_odds_t,
                         const VoxelEvidence& e) { total += static_cast<double>(e.total()); },
                     false);
    return total;
}

/** What instances know of their voxels, against a recount of the whole map. */
void expectConsistent(const SemanticVoxelMap& map)
{
    std::map<instance_id_t, uint32_t> voxels;
    map.forEachVoxel(
        [&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
            EXPECT_GT(evidence.size(), 0u);
            float known = 0;
            for (const auto& e : evidence)
                if (e.instance != UNKNOWN_INSTANCE) known += e.alpha;
            const auto membership = static_cast<float>(map.options().membership);
            for (const auto& e : evidence) {
                EXPECT_GT(e.alpha, 0);
                if (e.instance == UNKNOWN_INSTANCE) continue;
                if (e.alpha >= membership * known) ++voxels[e.instance];
                const auto at = map.instances().find(e.instance);
                ASSERT_NE(at, map.instances().end()) << "evidence for an instance that is gone";
                EXPECT_EQ(at->second.blocks.count(blockOf(v)), 1u);
            }
        },
        false);
    for (const auto& [id, instance] : map.instances()) {
        EXPECT_EQ(instance.id, id);
        EXPECT_EQ(instance.voxels, voxels[id]) << "instance " << id;
    }
}
}  // namespace

TEST(SemanticVoxelMap, StaysConsistentUnderRandomChanges)
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        std::mt19937 random(seed);
        SemanticVoxelMap map;
        std::set<instance_id_t> everSeen;
        for (int i = 0; i < 1500; ++i) {
            const auto before = test::liveIds(map);
            changeAtRandom(map, random);
            for (const auto& [id, instance] : map.instances()) {
                const bool isNew = std::find(before.begin(), before.end(), id) == before.end();
                ASSERT_TRUE(!isNew || everSeen.insert(id).second) << "id " << id << " reused";
            }
            if (i % 50 == 0) expectConsistent(map);
        }
        expectConsistent(map);
        for (const instance_id_t id : everSeen) {
            const instance_id_t now = map.resolve(id);
            ASSERT_TRUE(now == UNKNOWN_INSTANCE || map.instances().count(now) == 1);
            ASSERT_TRUE(map.instances().count(id) == 0 || now == id);
        }
    }
}

TEST(SemanticVoxelMap, MergingSplittingAndDroppingConserveEvidence)
{
    std::mt19937 random(31);
    SemanticVoxelMap map;
    double added = 0;
    for (int i = 0; i < 6; ++i) map.createInstance().categories.add(0, 1 + i);
    for (int i = 0; i < 2000; ++i) {
        const float alpha = 1 + static_cast<float>(i % 7);  // sums of whole numbers are exact
        std::uniform_int_distribution<int32_t> place(-9, 9);
        map.addEvidence({place(random), place(random), 0}, static_cast<instance_id_t>(i % 7),
                        alpha);
        added += static_cast<double>(alpha);
    }
    EXPECT_EQ(evidenceInVoxels(map), added);
    map.merge(2, 5, 0);
    auto part = voxelsOf(map, 2);
    part.resize(part.size() / 2);
    const instance_id_t half = map.split(2, part, 0.25, 0).id;
    map.merge(half, 1, 0);
    map.deactivate(3);
    EXPECT_EQ(evidenceInVoxels(map), added);
    expectConsistent(map);

    // 2 had 2 + 5; a quarter went to `half`, which absorbed 1.
    EXPECT_DOUBLE_EQ(map.instance(2).categories.sum().total(), 0.75 * 7);
    EXPECT_DOUBLE_EQ(map.instance(half).categories.sum().total(), 0.25 * 7 + 1);
}

TEST(SemanticVoxelMap, MergeKeepsTheHistoryOfBoth)
{
    SemanticVoxelMap map;
    const instance_id_t a = map.createInstance().id, b = map.createInstance().id;
    map.instance(a).observations = 2;
    map.instance(a).firstFrame = 5;
    map.saw(a, 6);
    map.instance(a).tracks = {1};
    map.instance(b).observations = 3;
    map.instance(b).firstFrame = 4;
    map.saw(b, 9);
    map.instance(b).tracks = {1, 7};
    map.addEvidence({0, 0, 0}, a, 2);
    map.addEvidence({0, 0, 0}, b, 3);
    map.addEvidence({-20, 0, 0}, b, 4);
    map.merge(a, b, 0);

    const Instance& merged = map.instance(a);
    EXPECT_EQ(merged.observations, 5u);
    EXPECT_EQ(merged.firstFrame, 4u);
    EXPECT_EQ(merged.lastFrame, 9u);
    EXPECT_EQ(merged.tracks, (std::set<int64_t>{1, 7}));
    EXPECT_EQ(merged.voxels, 2u);
    EXPECT_EQ(map.evidence({0, 0, 0})->alphaOf(a), 5);
    EXPECT_EQ(map.evidence({-20, 0, 0})->alphaOf(a), 4);
    EXPECT_THROW(static_cast<void>(map.instance(b)), std::out_of_range);
    EXPECT_THROW(map.merge(a, a, 0), std::invalid_argument);
}

TEST(SemanticVoxelMap, OldIdsResolveThroughChainsOfMerges)
{
    SemanticVoxelMap map;
    for (int i = 0; i < 5; ++i) map.createInstance();
    map.merge(2, 1, 0);
    map.merge(3, 2, 0);
    map.merge(5, 3, 0);
    EXPECT_EQ(map.resolve(1), 5u);
    EXPECT_EQ(map.resolve(2), 5u);
    EXPECT_EQ(map.resolve(4), 4u);
    EXPECT_EQ(map.resolve(77), UNKNOWN_INSTANCE);
    EXPECT_EQ(map.createInstance().id, 6u);
}

TEST(SemanticVoxelMap, InactiveInstancesLoseTheirVoxelsAndKeepTheirEvidence)
{
    SemanticVoxelMap map;
    const instance_id_t weak = map.createInstance().id, other = map.createInstance().id;
    const VoxelCoord shared{1, 2, -3}, alone{4, 0, 0};
    map.addEvidence(shared, weak, 4);
    map.addEvidence(shared, other, 1);
    map.addEvidence(alone, weak, 2);
    const auto winnerAt = [&](const VoxelCoord& v) { return map.winner(*map.evidence(v)); };
    EXPECT_EQ(winnerAt(shared), weak);
    map.deactivate(weak);
    EXPECT_EQ(winnerAt(shared), other);
    EXPECT_EQ(winnerAt(alone), UNKNOWN_INSTANCE);
    EXPECT_EQ(map.evidence(shared)->alphaOf(weak), 4);
    EXPECT_EQ(map.instance(weak).voxels, 2u);
    map.reactivate(weak);
    EXPECT_EQ(winnerAt(shared), weak);
    EXPECT_THROW(map.deactivate(77), std::out_of_range);
}

TEST(SemanticVoxelMap, NothingIsNoEvidence)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    for (const float alpha : {0.0F, -1.0F, std::nanf(""), 1e-30F * 1e-30F}) {
        map.addEvidence({1, 2, 3}, id, alpha);
        map.addEvidence({1, 2, 3}, UNKNOWN_INSTANCE, alpha);
    }
    EXPECT_EQ(map.evidence({1, 2, 3}), nullptr);
    EXPECT_EQ(map.instance(id).voxels, 0U);
    EXPECT_TRUE(map.empty());
}

TEST(SemanticVoxelMap, ASplitSharesTheObservations)
{
    SemanticVoxelMap map;
    map.createInstance().observations = 10;
    const instance_id_t part = map.split(1, {}, 0.28, 0).id;
    EXPECT_EQ(map.instance(part).observations, 3U);
    EXPECT_EQ(map.instance(1).observations, 7U);
    map.merge(1, part, 0);
    EXPECT_EQ(map.instance(1).observations, 10U);
}

TEST(SemanticVoxelMap, AnAbsorbedInstanceIsNoLongerInactive)
{
    SemanticVoxelMap map;
    const instance_id_t a = map.createInstance().id, b = map.createInstance().id;
    map.deactivate(b);
    map.merge(a, b, 0);
    EXPECT_TRUE(map.inactive().empty());
}

TEST(SemanticVoxelMap, VisitsVoxelsInOrderAndOccupiedOnesOnlyByDefault)
{
    SemanticVoxelMap map;
    std::vector<VoxelCoord> occupied, all;
    for (const VoxelCoord& v :
         {VoxelCoord{9, 0, 0}, VoxelCoord{-1, 0, 0}, VoxelCoord{0, 0, -9}, VoxelCoord{2, 1, 0}})
        map.addEvidence(v, UNKNOWN_INSTANCE, 1);
    map.blocks().at({1, 0, 0}).setOccupancy(cellOf({9, 0, 0}), 100);
    map.blocks().at({0, 0, 0}).setOccupancy(cellOf({2, 1, 0}), -100);
    const auto into = [](std::vector<VoxelCoord>& list) {
        return
            [&list](const VoxelCoord& v, log_odds_t, const VoxelEvidence&) { list.push_back(v); };
    };
    map.forEachVoxel(into(occupied));
    map.forEachVoxel(into(all), false);
    EXPECT_EQ(occupied, (std::vector<VoxelCoord>{{9, 0, 0}}));
    EXPECT_EQ(all, (std::vector<VoxelCoord>{{0, 0, -9}, {-1, 0, 0}, {2, 1, 0}, {9, 0, 0}}));
}

TEST(SemanticVoxelMap, UnknownVoxelsAreUnobserved)
{
    SemanticVoxelMap map;
    EXPECT_TRUE(map.empty());
    EXPECT_EQ(map.occupancy({1, 2, 3}), UNOBSERVED);
    EXPECT_EQ(map.evidence({1, 2, 3}), nullptr);
    map.addEvidence({0, 0, 0}, UNKNOWN_INSTANCE, 1);
    EXPECT_FALSE(map.empty());
    EXPECT_EQ(map.occupancy({1, 2, 3}), UNOBSERVED);
    EXPECT_EQ(map.evidence({1, 2, 3}), nullptr);
    map.clear();
    EXPECT_TRUE(map.empty());
}

TEST(SemanticVoxelMap, CopiesAreIndependent)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    for (int i = 0; i < 10; ++i) map.addEvidence({0, 0, 0}, map.createInstance().id, 1);
    SemanticVoxelMap copy = map;
    copy.addEvidence({0, 0, 0}, id, 1);
    copy.merge(1, 2, 0);
    EXPECT_EQ(map.evidence({0, 0, 0})->size(), 10u);
    EXPECT_EQ(map.instance(id).voxels, 0u);
    expectConsistent(copy);
    expectConsistent(map);
}

TEST(SemanticVoxelMap, OptionsThatShapeTheVoxelsAreFixedOnceThereAreSome)
{
    MapOptions options;
    options.resolution = 0;
    EXPECT_THROW(SemanticVoxelMap{options}, std::invalid_argument);
    options.resolution = 0.1;
    options.prior_strength = -1;
    EXPECT_THROW(SemanticVoxelMap{options}, std::invalid_argument);
    options.prior_strength = 2;

    SemanticVoxelMap map;
    EXPECT_NO_THROW(map.setOptions(options));
    EXPECT_EQ(map.resolution(), 0.1);
    map.addEvidence({0, 0, 0}, UNKNOWN_INSTANCE, 1);
    MapOptions other = options;
    other.resolution = 0.2;
    EXPECT_THROW(map.setOptions(other), std::invalid_argument);
    other = options;
    other.occupancy.prob_hit = 0.8;
    EXPECT_THROW(map.setOptions(other), std::invalid_argument);
    other = options;
    other.prior_strength = 0;
    other.entropy = EntropyMeasure::paper;
    EXPECT_NO_THROW(map.setOptions(other));
    EXPECT_EQ(map.options().entropy, EntropyMeasure::paper);
}

TEST(SemanticVoxelMap, KnowsWhichInstancesWereSeenSinceAFrame)
{
    SemanticVoxelMap map;
    std::vector<instance_id_t> ids;
    for (int i = 0; i < 5; ++i) ids.push_back(map.createInstance().id);
    map.saw(ids[3], 4);
    map.saw(ids[1], 9);
    map.saw(ids[2], 4);
    map.saw(ids[2], 7);
    const auto since = [&](uint32_t frame) { return map.seenSince(frame); };
    using Ids = std::vector<instance_id_t>;
    EXPECT_EQ(since(0), ids);
    EXPECT_EQ(since(4), (Ids{ids[1], ids[2], ids[3]}));
    EXPECT_EQ(since(8), Ids{ids[1]});
    map.merge(ids[0], ids[1], 9);
    EXPECT_EQ(since(5), (Ids{ids[0], ids[2]}));
    EXPECT_EQ(since(10), Ids());
}
