// SPDX-License-Identifier: BSD-3-Clause
/** Which instance an opinion goes to, from overlaps written down by hand. */
#include "HandMadeMap.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
/** Two opinions of 100 voxels each. \param shared voxels they have in common */
struct TwoOpinions
{
    explicit TwoOpinions(uint32_t shared)
    {
        for (Opinion& o : opinions) o.voxels.resize(100);
        overlaps.resize(2);
        for (size_t i = 0; i < 2; ++i) overlaps[i].opinion = &opinions[i];
        overlaps[0].shared = {0, shared};
        overlaps[1].shared = {shared, 0};
    }

    /** Both overlap with one instance of 200 visible voxels. */
    std::vector<instance_id_t> assigned(uint32_t first, uint32_t second, double similarity,
                                        const std::string& keys = "ablation = unclaimed")
    {
        overlaps[0].candidates = {{7, first, 100, 200, 200, 100, similarity}};
        overlaps[1].candidates = {{7, second, 100, 200, 200, 100, similarity}};
        const auto assignments = evidentialPolicy(keys)->associate(overlaps, SemanticVoxelMap());
        return {assignments[0].instance, assignments[1].instance};
    }

    Opinion opinions[2];
    std::vector<OpinionOverlaps> overlaps;
};
using Ids = std::vector<instance_id_t>;

/** Where one opinion goes that overlaps as given, if nothing else is in the frame. */
instance_id_t assigned(const std::vector<Overlap>& candidates, const std::string& keys = "")
{
    Opinion opinion;
    opinion.voxels.resize(100);
    OpinionOverlaps overlaps;
    overlaps.opinion = &opinion;
    overlaps.shared = {0};
    overlaps.candidates = candidates;
    return evidentialPolicy(keys)->associate({overlaps}, SemanticVoxelMap())[0].instance;
}
}  // namespace

TEST(EvidentialAssociation, DetectionsThatLieApartAreTwoObjects)
{
    // Each lies within the instance and covers nearly half of it: the better one gets it.
    EXPECT_EQ(TwoOpinions(49).assigned(95, 90, 1), (Ids{7, UNKNOWN_INSTANCE}));
    EXPECT_EQ(TwoOpinions(49).assigned(90, 95, 1), (Ids{UNKNOWN_INSTANCE, 7}));
}

TEST(EvidentialAssociation, DetectionsThatOverlapMayBeOneObjectTwice)
{
    EXPECT_EQ(TwoOpinions(50).assigned(95, 90, 1), (Ids{7, 7}));
}

TEST(EvidentialAssociation, APieceNeedsToLieWithinAndToBeSimilar)
{
    // IoV is below 0.5: too little for a visible part where categories differ so.
    EXPECT_EQ(TwoOpinions(100).assigned(80, 79, 0.2), (Ids{7, UNKNOWN_INSTANCE}));
    EXPECT_EQ(TwoOpinions(100).assigned(99, 80, 0.19), (Ids{UNKNOWN_INSTANCE, UNKNOWN_INSTANCE}));
}

TEST(EvidentialAssociation, WhatOverlapsLessButIsNamedAlikeIsPreferred)
{
    EXPECT_EQ(assigned({{3, 90, 100, 150, 150, 100, 0.1},    // 0.6 + 0.9 + 0.1
                        {8, 80, 100, 200, 200, 100, 0.5}}),  // 0.4 + 0.8 + 0.5
              8U);
}

TEST(EvidentialAssociation, WhatLiesWithinTheInstanceIsPreferredToWhatCoversIt)
{
    EXPECT_EQ(assigned({{3, 90, 100, 120, 120, 100, 0},  // IoV 0.75 + IoM 0.9
                        {8, 70, 100, 90, 90, 100, 0}}),  // IoV 0.78 + IoM 0.7
              3U);
}

TEST(EvidentialAssociation, AnInstanceNobodyClaimsIsSeenUnderAnotherName)
{
    // IoV 0.25 and IoM 0.5: far from what differing categories need otherwise.
    EXPECT_EQ(assigned({{3, 50, 100, 400, 200, 100, 0}}), 3U);
    EXPECT_EQ(assigned({{3, 49, 100, 400, 200, 100, 0}}), UNKNOWN_INSTANCE);  // IoV 0.245
    EXPECT_EQ(assigned({{3, 24, 100, 400, 50, 100, 0}}), UNKNOWN_INSTANCE);   // IoM 0.24
    EXPECT_EQ(assigned({{3, 50, 100, 400, 200, 100, 0}}, "ablation = unclaimed"), UNKNOWN_INSTANCE);
    EXPECT_EQ(assigned({{3, 50, 100, 400, 200, 100, 0}}, "ablation = iov"), UNKNOWN_INSTANCE);
}

TEST(EvidentialAssociation, AClaimedInstanceIsNotSeenUnderAnotherName)
{
    // The first matches as usual; the second would if the instance were free. They share half of
    // their voxels, so that they do not lie apart.
    TwoOpinions two(50);
    EXPECT_EQ(two.assigned(95, 50, 0.6, "ablation ="), (Ids{7, UNKNOWN_INSTANCE}));
    EXPECT_EQ(two.assigned(50, 51, 0.6, "ablation ="), (Ids{UNKNOWN_INSTANCE, 7}))
        << "of two that would, the better one";
}

TEST(EvidentialAssociation, AnOutvotedInstanceIsFoundWhereItWasSeen)
{
    // Of no voxel of the opinion enough evidence is for it, but it was seen in 80 of 100.
    Overlap outvoted{3, 0, 100, 20, 0, 100, 0.2, 80};
    EXPECT_EQ(assigned({outvoted}), 3U);
    outvoted.touchedVoxels = 79;
    EXPECT_EQ(assigned({outvoted}), UNKNOWN_INSTANCE);
    outvoted.touchedVoxels = 80;
    EXPECT_EQ(assigned({outvoted}, "ablation = similarity"), UNKNOWN_INSTANCE);
    outvoted.similarity = 0.19;
    EXPECT_EQ(assigned({outvoted}), UNKNOWN_INSTANCE);
    EXPECT_EQ(assigned({outvoted}, "tau_iou = 0"), UNKNOWN_INSTANCE) << "no voxel in common";
}
