// SPDX-License-Identifier: BSD-3-Clause
#include "evidence/Displacement.h"
#include "pipeline/Integration.h"
#include "support/Frames.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace voxeland;

namespace
{
constexpr double RESOLUTION = 0.05;

/** A wall at 1.02 m, 2.5 cm a pixel: four pixels a voxel, in the middle of the image. */
PreparedFrame wallFrame()
{
    RgbdFrame frame;
    frame.scan = test::makeScan(
        [](int c, int r) { return c >= 30 && c < 50 && r >= 20 && r < 40 ? 1.02 : 0.0; });
    VoxelizedFrame voxels(frame, RESOLUTION, {});
    auto space = castRays(voxels, 0.1);
    return {std::move(voxels), {}, std::move(space), true, {}};
}

/** An uncertainty that displaces everything by so much, root mean square [m]. */
PoseUncertainty shaking(double displacement)
{
    mrpt::math::CMatrixDouble66 covariance;
    covariance.setZero();
    for (int i = 0; i < 3; ++i) covariance(i, i) = displacement * displacement / 3;
    return {mrpt::poses::CPose3D(), covariance};
}

/** Number of the first hit voxel with at least this many points. */
uint32_t hitWith(const PreparedFrame& frame, uint32_t points)
{
    for (uint32_t h = 0; h < frame.voxels.hits().size(); ++h)
        if (frame.voxels.hits()[h].points >= points) return h;
    ADD_FAILURE() << "no such voxel";
    return 0;
}

/** The paper's rule: each point and each opinion counts. */
IntegrationOptions plainly(double unknownWeight, double sharpness = 1)
{
    IntegrationOptions options;
    options.evidence = EvidenceRule::sum;
    options.unknown_weight = unknownWeight;
    options.sharpness = sharpness;
    return options;
}

Opinion opinion(uint32_t hit, float points, float confidence)
{
    return {{{hit, points}}, {{"chair", 1}}, confidence, InstancePrediction::NO_TRACK};
}

/** A frame with an opinion about an instance of an empty map. */
struct ClaimedHit
{
    SemanticVoxelMap map;
    instance_id_t id;
    PreparedFrame frame;
    uint32_t hit;  //!< the voxel of the opinion
    float points;  //!< that the voxel holds
};

/** Of one voxel's points, all but one belong to the instance. */
ClaimedHit allButOnePointClaimed()
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    auto frame = wallFrame();
    const uint32_t hit = hitWith(frame, 4);
    const auto points = static_cast<float>(frame.voxels.hits()[hit].points);
    frame.opinions = {opinion(hit, points - 1, 0.5F)};
    return {std::move(map), id, std::move(frame), hit, points};
}
}  // namespace

TEST(IntegrateOccupancy, EachVoxelIsUpdatedOncePerFrame)
{
    SemanticVoxelMap map;
    const auto frame = wallFrame();
    for (int times = 1; times <= 2; ++times) {
        integrateOccupancy(frame.space, map);
        const double hit = std::pow(0.7 / 0.3, times), miss = std::pow(0.4 / 0.6, times);
        size_t updated = 0;
        for (size_t b = 0; b < frame.space.size(); ++b) {
            const auto at = [&](int cell) {
                ++updated;
                return OccupancyFilter::probability(
                    map.occupancy(voxelAt(frame.space.coordOf(b), cell)));
            };
            frame.space[b].hit.forEach(
                [&](int cell) { EXPECT_NEAR(at(cell), hit / (1 + hit), 1e-3); });
            frame.space[b].passed.forEach(
                [&](int cell) { EXPECT_NEAR(at(cell), miss / (1 + miss), 1e-3); });
        }
        EXPECT_EQ(map.memory().observedVoxels, updated) << "what is behind stays unobserved";
    }
}

TEST(IntegrateOccupancy, CountsLessWhereThePoseIsUncertain)
{
    SemanticVoxelMap map;
    const auto frame = wallFrame();
    const auto uncertainty = shaking(0.05);
    integrateOccupancy(frame.space, map, uncertainty);
    const double trust = probabilityOfStaying(0.05, RESOLUTION);
    for (const HitVoxel& h : frame.voxels.hits()) {
        const double p = OccupancyFilter::probability(map.occupancy(h.coord));
        EXPECT_NEAR(std::log(p / (1 - p)), trust * std::log(0.7 / 0.3), 1e-3);
    }
}

TEST(IntegrateGeometry, CountsLessWhereThePoseIsUncertain)
{
    auto [map, id, frame, hit, points] = allButOnePointClaimed();
    frame.uncertainty = shaking(0.02);
    integrateGeometry(frame, {id}, {}, plainly(0.2), map);
    const VoxelEvidence& evidence = *map.evidence(frame.voxels.hits()[hit].coord);
    const auto trust = static_cast<float>(probabilityOfStaying(0.02, RESOLUTION));
    EXPECT_FLOAT_EQ(evidence.alphaOf(id), trust * (points - 1));
    EXPECT_FLOAT_EQ(evidence.alphaOf(UNKNOWN_INSTANCE), trust * 0.2F);
}

TEST(IntegrateGeometry, PointsNobodyClaimsAreWeighedForUnknown)
{
    SemanticVoxelMap map;
    const auto frame = wallFrame();
    integrateGeometry(frame, {}, {}, plainly(0.25), map);
    for (const HitVoxel& h : frame.voxels.hits()) {
        const VoxelEvidence* evidence = map.evidence(h.coord);
        ASSERT_NE(evidence, nullptr);
        EXPECT_EQ(evidence->size(), 1u);
        EXPECT_FLOAT_EQ(evidence->alphaOf(UNKNOWN_INSTANCE), 0.25F * static_cast<float>(h.points));
    }
}

TEST(IntegrateGeometry, WhatTheDetectorMissedIsNoEvidenceForUnknown)
{
    const auto frame = wallFrame();
    const VoxelCoord won = frame.voxels.hits()[0].coord, lost = frame.voxels.hits()[1].coord,
                     others = frame.voxels.hits()[2].coord, nobodys = frame.voxels.hits()[3].coord;
    SemanticVoxelMap map;
    const instance_id_t missed = map.createInstance().id, seen = map.createInstance().id;
    map.addEvidence(won, missed, 2);
    map.addEvidence(lost, missed, 2);
    map.addEvidence(lost, UNKNOWN_INSTANCE, 3);
    map.addEvidence(others, seen, 2);
    integrateGeometry(frame, {}, {missed}, plainly(0.2), map);
    const auto unknownAt = [&](const VoxelCoord& v) {
        return map.evidence(v)->alphaOf(UNKNOWN_INSTANCE);
    };
    EXPECT_EQ(unknownAt(won), 0);
    EXPECT_GT(unknownAt(lost), 3) << "unknown has won that voxel before";
    EXPECT_GT(unknownAt(others), 0);
    EXPECT_GT(unknownAt(nobodys), 0);
}

TEST(IntegrateGeometry, ClaimedPointsGoToTheInstanceAndTheRestToUnknown)
{
    auto [map, id, frame, hit, points] = allButOnePointClaimed();
    integrateGeometry(frame, {id}, {}, plainly(0.2), map);
    const VoxelEvidence& evidence = *map.evidence(frame.voxels.hits()[hit].coord);
    EXPECT_FLOAT_EQ(evidence.alphaOf(id), points - 1) << "confidence does not weigh a sole claim";
    EXPECT_FLOAT_EQ(evidence.alphaOf(UNKNOWN_INSTANCE), 0.2F);
    EXPECT_EQ(map.instance(id).voxels, 1u);
}

namespace
{
/** What instances get of one voxel's points when each has an opinion about some of them. */
struct SharedHit
{
    SemanticVoxelMap map;
    PreparedFrame frame = wallFrame();
    uint32_t hit = hitWith(frame, 4);
    float points = static_cast<float>(frame.voxels.hits()[hit].points);
    std::vector<instance_id_t> ids = {};

    void claim(float claimed, float confidence)
    {
        ids.push_back(map.createInstance().id);
        frame.opinions.push_back(opinion(hit, claimed, confidence));
    }
    /** alpha of each opinion's instance, that of *unknown* last. */
    std::vector<float> shared()
    {
        integrateGeometry(frame, ids, {}, plainly(0.5), map);
        const VoxelEvidence& evidence = *map.evidence(frame.voxels.hits()[hit].coord);
        std::vector<float> alpha;
        for (const instance_id_t id : ids) alpha.push_back(evidence.alphaOf(id));
        alpha.push_back(evidence.alphaOf(UNKNOWN_INSTANCE));
        return alpha;
    }
};

void expectNear(const std::vector<float>& found, const std::vector<float>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-5) << i;
}
}  // namespace

TEST(IntegrateGeometry, EachKeepsItsOwnWhereThereIsEnough)
{
    SharedHit voxel;
    voxel.claim(1, 0.9F);
    voxel.claim(voxel.points - 2, 0.1F);
    EXPECT_EQ(voxel.shared(), (std::vector<float>{1, voxel.points - 2, 0.5F}));
}

TEST(IntegrateGeometry, PointsClaimedTwiceGoToTheSurerOne)
{
    SharedHit voxel;
    voxel.claim(voxel.points, 0.3F);
    voxel.claim(voxel.points, 0.9F);
    expectNear(voxel.shared(), {0, voxel.points, 0});
}

TEST(IntegrateGeometry, OnlyTheExcessIsTakenAndNobodyGetsMoreThanItClaimed)
{
    SharedHit voxel;  // one point too many is claimed
    voxel.claim(voxel.points - 1, 0.1F);
    voxel.claim(2, 0.9F);
    expectNear(voxel.shared(), {voxel.points - 2, 2, 0});
}

TEST(IntegrateGeometry, TheExcessIsTakenFromTheLeastSpecificFirst)
{
    // Of 8 eighths 3 + 4 + 5 are claimed: the surest keeps 4, the next one 3, and 1 is left.
    SharedHit voxel;
    const float eighth = voxel.points / 8;
    voxel.claim(5 * eighth, 0.25F);
    voxel.claim(4 * eighth, 1);
    voxel.claim(3 * eighth, 0.5F);
    expectNear(voxel.shared(), {eighth, 4 * eighth, 3 * eighth, 0});
}

TEST(IntegrateGeometry, ASmallMaskOnALargeOneSaysMoreAboutItsPoints)
{
    SharedHit voxel;
    voxel.claim(voxel.points, 0.9F);      // a table of three voxels
    voxel.claim(voxel.points - 1, 0.6F);  // a cup of one
    for (const uint32_t other : {voxel.hit + 1, voxel.hit + 2})
        voxel.frame.opinions[0].voxels.push_back({other, 1});
    expectNear(voxel.shared(), {1, voxel.points - 1, 0});
}

TEST(IntegrateGeometry, TwoOpinionsAboutOneInstanceCountTheirPointsOnce)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    auto frame = wallFrame();
    const uint32_t hit = hitWith(frame, 4);
    const auto points = static_cast<float>(frame.voxels.hits()[hit].points);
    frame.opinions = {opinion(hit, points, 0.9F), opinion(hit, points, 0.3F)};
    integrateGeometry(frame, {id, id}, {}, plainly(0.2), map);
    EXPECT_FLOAT_EQ(map.evidence(frame.voxels.hits()[hit].coord)->alphaOf(id), points);
}

TEST(IntegrateSemantics, BetaGrowsByConfidenceTimesProbability)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    const category_id_t chair = map.categories().add("chair"), sofa = map.categories().add("sofa");
    Opinion o = opinion(0, 1, 0.5F);
    o.track = 9;
    OpinionOverlaps overlaps;
    overlaps.opinion = &o;
    overlaps.categories.add(chair, 0.75);
    overlaps.categories.add(sofa, 0.25);
    const auto frame = wallFrame();
    integrateSemantics(frame, {overlaps}, {id}, 4, plainly(0), map);
    integrateSemantics(frame, {overlaps, overlaps}, {id, id}, 7, plainly(0), map);
    const Instance& instance = map.instance(id);
    EXPECT_DOUBLE_EQ(instance.evidence().betaOf(chair), 3 * 0.375);
    EXPECT_DOUBLE_EQ(instance.evidence().betaOf(sofa), 3 * 0.125);
    EXPECT_EQ(instance.observations, 3u);
    EXPECT_EQ(instance.firstFrame, 4u);
    EXPECT_EQ(instance.lastFrame, 7u);
    EXPECT_EQ(instance.tracks, (std::set<int64_t>{9}));
}

TEST(IntegrateGeometry, PointsOfAFrameInOneVoxelRepeatEachOther)
{
    SemanticVoxelMap map;
    const auto frame = wallFrame();
    IntegrationOptions options;
    options.unknown_weight = 0.25;
    integrateGeometry(frame, {}, {}, options, map);
    for (const HitVoxel& h : frame.voxels.hits()) {
        const auto n = static_cast<float>(h.points);
        EXPECT_FLOAT_EQ(map.evidence(h.coord)->alphaOf(UNKNOWN_INSTANCE), 0.25F * 2 * n / (n + 1));
    }

    auto claimed = allButOnePointClaimed();
    integrateGeometry(claimed.frame, {claimed.id}, {}, options, claimed.map);
    const VoxelEvidence& evidence =
        *claimed.map.evidence(claimed.frame.voxels.hits()[claimed.hit].coord);
    const float each = 2 / (claimed.points + 1);
    EXPECT_FLOAT_EQ(evidence.alphaOf(claimed.id), each * (claimed.points - 1));
    EXPECT_FLOAT_EQ(evidence.alphaOf(UNKNOWN_INSTANCE), 0.25F * each);
}

TEST(IntegrateSemantics, AnOpinionCountsByWhatItAddsToThoseAboutTheSameSide)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    const category_id_t chair = map.categories().add("chair"), sofa = map.categories().add("sofa");
    auto frame = wallFrame();
    const auto say = [&](category_id_t category, float confidence, const PreparedFrame& seenFrom) {
        const Opinion o = opinion(hitWith(frame, 4), 4, confidence);
        OpinionOverlaps overlaps;
        overlaps.opinion = &o;
        overlaps.categories.add(category, 1);
        integrateSemantics(seenFrom, {overlaps}, {id}, 0, IntegrationOptions(), map);
    };
    for (int i = 0; i < 3; ++i) say(chair, 0.5F, frame);
    say(sofa, 0.75F, frame);
    // Four of one side, any two correlated by one half: 1 / (1 + 3 / 2) of their sum.
    EXPECT_NEAR(map.instance(id).evidence().betaOf(chair), 0.4 * 3 * 0.5, 1e-12);
    EXPECT_NEAR(map.instance(id).evidence().betaOf(sofa), 0.4 * 0.75, 1e-12);
    EXPECT_NEAR(map.instance(id).categories.sum().betaOf(chair), 3 * 0.5, 1e-12);
}

TEST(IntegrateSemantics, WhatIsSeenAgainIsActiveAgain)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id, other = map.createInstance().id;
    map.deactivate(id);
    map.deactivate(other);
    const Opinion o = opinion(0, 1, 0.5F);
    OpinionOverlaps overlaps;
    overlaps.opinion = &o;
    integrateSemantics(wallFrame(), {overlaps}, {id}, 0, plainly(0), map);
    EXPECT_EQ(map.inactive(), std::set<instance_id_t>{other});
}

TEST(IntegrateSemantics, APartOfASplitKeepsItsFirstFrameUntilItIsSeenAlone)
{
    SemanticVoxelMap map;
    Instance& whole = map.createInstance();
    whole.observations = 1;
    whole.firstFrame = 3;
    const instance_id_t part = map.split(whole.id, {}, 0.25, 9).id;
    ASSERT_EQ(map.instance(part).observations, 0U);
    const Opinion o = opinion(0, 1, 0.5F);
    OpinionOverlaps overlaps;
    overlaps.opinion = &o;
    integrateSemantics(wallFrame(), {overlaps}, {part}, 12, plainly(0), map);
    EXPECT_EQ(map.instance(part).firstFrame, 3U);
    EXPECT_EQ(map.instance(part).lastFrame, 12U);
}

TEST(IntegrateSemantics, SharpnessFavoursTheMostProbableCategory)
{
    SemanticVoxelMap map;
    const instance_id_t id = map.createInstance().id;
    const category_id_t chair = map.categories().add("chair"), sofa = map.categories().add("sofa");
    const Opinion o = opinion(0, 1, 0.5F);
    OpinionOverlaps overlaps;
    overlaps.opinion = &o;
    overlaps.categories.add(chair, 0.75);
    overlaps.categories.add(sofa, 0.25);
    // 9/16 : 1/16 -> 0.9 : 0.1
    integrateSemantics(wallFrame(), {overlaps}, {id}, 0, plainly(0, 2), map);
    EXPECT_NEAR(map.instance(id).evidence().betaOf(chair), 0.5 * 0.9, 1e-12);
    EXPECT_NEAR(map.instance(id).evidence().betaOf(sofa), 0.5 * 0.1, 1e-12);
}

TEST(ResolveAssignments, NewInstancesOfOneNumberAreOne)
{
    SemanticVoxelMap map;
    const instance_id_t known = map.createInstance().id;
    const auto ids = resolveAssignments(
        {{UNKNOWN_INSTANCE, 5}, {known, 0}, {UNKNOWN_INSTANCE, 0}, {UNKNOWN_INSTANCE, 5}}, map);
    EXPECT_EQ(ids, (std::vector<instance_id_t>{2, known, 3, 2}));
    EXPECT_EQ(map.instances().size(), 3u);
}

TEST(RecordViews, EachOpinionIsAViewOfItsLikeliestCategory)
{
    SemanticVoxelMap map;
    const category_id_t chair = map.categories().add("chair"), sofa = map.categories().add("sofa");
    auto frame = wallFrame();
    frame.time = mrpt::Clock::fromDouble(7);
    const uint32_t hit = hitWith(frame, 4);
    frame.opinions = {opinion(hit, 4, 0.5F), opinion(hit, 4, 0.5F)};
    frame.opinions[0].region = {{3, 4, 20, 10}, 150, true};
    std::vector<OpinionOverlaps> overlaps(2);
    for (size_t i = 0; i < 2; ++i) {
        overlaps[i].opinion = &frame.opinions[i];
        overlaps[i].categories.add(chair, 0.25);
        overlaps[i].categories.add(sofa, 0.75);
    }
    const instance_id_t shown = map.createInstance().id, hidden = map.createInstance().id;
    recordViews(frame, overlaps, {shown, hidden}, 12, map);

    ASSERT_EQ(map.instance(shown).views.byCategory().size(), 1U);
    const auto& views = map.instance(shown).views.of(sofa);
    ASSERT_EQ(views.size(), 1U);
    EXPECT_EQ(views[0].frame, 12U);
    EXPECT_EQ(views[0].time, mrpt::Clock::fromDouble(7));
    EXPECT_EQ(views[0].box, (PixelBox{3, 4, 20, 10}));
    EXPECT_EQ(views[0].area, 150U);
    EXPECT_TRUE(views[0].truncated);
    EXPECT_EQ(views[0].score, 0.5F);
    EXPECT_EQ(views[0].probability, 0.75F);
    const auto& seen = frame.voxels.hits()[hit].centroid;
    EXPECT_EQ(views[0].camera, mrpt::math::TPoint3Df(frame.voxels.origin()));
    EXPECT_NEAR(views[0].target.x, seen.x, 1e-6);
    EXPECT_NEAR(views[0].target.y, seen.y, 1e-6);
    EXPECT_TRUE(map.instance(hidden).views.byCategory().empty()) << "its region is not known";
}
