// SPDX-License-Identifier: BSD-3-Clause
/** The association policies that go by what the detector says, on overlaps made by hand. */
#include "plugins/PluginLoader.h"
#include "voxeland/plugins/CAssociationPolicy.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
constexpr category_id_t CHAIR = 0, TABLE = 1, SOFA = 2;

std::shared_ptr<CAssociationPolicy> policy(const std::string& library, const std::string& className)
{
    loadPlugin(library, pluginSearchPath());
    return createPlugin<CAssociationPolicy>(className);
}

/** Instances 1 (chair, some table; tracks 10, 11), 2 (chair, little; track 20), 3 (table; no
 *  track). */
SemanticVoxelMap threeInstances()
{
    SemanticVoxelMap map;
    for (const auto* name : {"chair", "table", "sofa"}) map.categories().add(name);
    Instance& first = map.createInstance();
    first.categories.add(CHAIR, 3);
    first.categories.add(TABLE, 2);
    first.tracks = {10, 11};
    Instance& second = map.createInstance();
    second.categories.add(CHAIR, 0.5);
    second.tracks = {20};
    map.createInstance().categories.add(TABLE, 4);
    return map;
}

/** An overlap so good that the other policies would match. */
Overlap nearlyEqual(instance_id_t instance)
{
    Overlap o;
    o.instance = instance;
    o.intersection = 90;
    o.opinionVoxels = o.instanceVoxels = o.visibleVoxels = 100;
    o.similarity = 1;
    return o;
}

OpinionOverlaps opinionOn(category_id_t category, std::vector<Overlap> candidates = {})
{
    OpinionOverlaps o;
    o.categories.add(category, 0.6);
    o.categories.add(category == CHAIR ? TABLE : CHAIR, 0.4);
    o.candidates = std::move(candidates);
    return o;
}

OpinionOverlaps opinionWith(const Opinion& opinion, std::vector<Overlap> candidates = {})
{
    OpinionOverlaps o = opinionOn(CHAIR, std::move(candidates));
    o.opinion = &opinion;
    return o;
}

Opinion tracked(int64_t track)
{
    Opinion o;
    o.track = track;
    return o;
}
}  // namespace

TEST(CategoryAssociation, FindsTheCategoryWhereverItIs)
{
    const auto p = policy("category_association", "CCategoryAssociation");
    const auto map = threeInstances();
    const auto a =
        p->associate({opinionOn(TABLE), opinionOn(CHAIR, {nearlyEqual(3)}), opinionOn(TABLE)}, map);
    ASSERT_EQ(a.size(), 3U);
    EXPECT_EQ(a[0].instance, 3U);
    EXPECT_EQ(a[1].instance, 1U) << "the older of two; what it overlaps does not matter";
    EXPECT_EQ(a[2].instance, 3U);
}

TEST(CategoryAssociation, NewOpinionsOfACategoryStartOneInstanceTogether)
{
    const auto p = policy("category_association", "CCategoryAssociation");
    const auto a = p->associate(
        {opinionOn(CHAIR), opinionOn(SOFA), opinionOn(TABLE), opinionOn(CHAIR), opinionOn(SOFA)},
        SemanticVoxelMap());
    ASSERT_EQ(a.size(), 5U);
    for (const Assignment& assignment : a) EXPECT_EQ(assignment.instance, UNKNOWN_INSTANCE);
    EXPECT_EQ(a[0].newInstance, a[3].newInstance);
    EXPECT_EQ(a[1].newInstance, a[4].newInstance);
    EXPECT_NE(a[0].newInstance, a[1].newInstance);
    EXPECT_NE(a[0].newInstance, a[2].newInstance);
    EXPECT_NE(a[1].newInstance, a[2].newInstance);
}

TEST(CategoryAssociation, OpinionsWithoutCategoriesStayTogether)
{
    const auto p = policy("category_association", "CCategoryAssociation");
    SemanticVoxelMap map = threeInstances();
    const auto created = p->associate({OpinionOverlaps(), opinionOn(SOFA), OpinionOverlaps()}, map);
    EXPECT_EQ(created[0].instance, UNKNOWN_INSTANCE);
    EXPECT_EQ(created[0].newInstance, created[2].newInstance);
    EXPECT_NE(created[0].newInstance, created[1].newInstance);
    const instance_id_t bare = map.createInstance().id;
    EXPECT_EQ(p->associate({OpinionOverlaps()}, map).at(0).instance, bare);
}

TEST(TrackAssociation, FindsTheTrackWhereverItIs)
{
    const auto p = policy("track_association", "CTrackAssociation");
    const auto map = threeInstances();
    const Opinion ten = tracked(10), eleven = tracked(11), twenty = tracked(20);
    const auto a =
        p->associate({opinionWith(eleven, {nearlyEqual(1), nearlyEqual(2)}),
                      opinionWith(twenty, {nearlyEqual(1)}), opinionWith(ten, {nearlyEqual(3)}),
                      opinionWith(twenty, {nearlyEqual(2)})},
                     map);
    ASSERT_EQ(a.size(), 4U);
    EXPECT_EQ(a[0].instance, 1U);
    EXPECT_EQ(a[1].instance, 2U) << "among the candidates of another opinion of the track only";
    EXPECT_EQ(a[2].instance, 1U) << "among no candidates";
    EXPECT_EQ(a[3].instance, 2U);
}

TEST(TrackAssociation, NewOpinionsOfATrackStartOneInstanceTogether)
{
    const auto p = policy("track_association", "CTrackAssociation");
    const auto map = threeInstances();
    const Opinion seven = tracked(7), eight = tracked(8);
    const auto a = p->associate({opinionWith(seven, {nearlyEqual(1)}),
                                 opinionWith(eight, {nearlyEqual(2)}), opinionWith(seven)},
                                map);
    ASSERT_EQ(a.size(), 3U);
    for (const Assignment& assignment : a) EXPECT_EQ(assignment.instance, UNKNOWN_INSTANCE);
    EXPECT_EQ(a[0].newInstance, a[2].newInstance);
    EXPECT_NE(a[0].newInstance, a[1].newInstance);
}

TEST(TrackAssociation, OpinionsWithoutTrackAreInstancesOfTheirOwn)
{
    const auto p = policy("track_association", "CTrackAssociation");
    const auto map = threeInstances();
    const Opinion untracked, seven = tracked(7);
    const auto a = p->associate({opinionWith(seven), opinionWith(untracked, {nearlyEqual(3)}),
                                 opinionWith(untracked, {nearlyEqual(3)}), opinionWith(seven)},
                                map);
    ASSERT_EQ(a.size(), 4U);
    EXPECT_EQ(a[1].instance, UNKNOWN_INSTANCE);
    EXPECT_EQ(a[2].instance, UNKNOWN_INSTANCE);
    EXPECT_NE(a[1].newInstance, a[2].newInstance);
    EXPECT_NE(a[1].newInstance, a[0].newInstance);
    EXPECT_NE(a[2].newInstance, a[0].newInstance);
}

TEST(CategoryAndTrackAssociation, NeverMerge)
{
    const auto map = threeInstances();
    const InstanceOverlap equal = {1, 2, 100, 100, 100, 1};
    EXPECT_FALSE(policy("category_association", "CCategoryAssociation")
                     ->mayMerge(equal, MergeThresholds(), map));
    EXPECT_FALSE(
        policy("track_association", "CTrackAssociation")->mayMerge(equal, MergeThresholds(), map));
}

TEST(CategoryEvidence, TopIsTheMostProbableOfEqualsTheFirst)
{
    CategoryEvidence evidence;
    EXPECT_EQ(evidence.top(), std::nullopt);
    evidence.add(SOFA, 2);
    evidence.add(CHAIR, 1);
    EXPECT_EQ(evidence.top(), SOFA);
    evidence.add(TABLE, 2);
    EXPECT_EQ(evidence.top(), TABLE);
}
