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
    std::vector<instance_id_t> assigned(uint32_t first, uint32_t second, double similarity)
    {
        overlaps[0].candidates = {{7, first, 100, 200, 200, 100, similarity}};
        overlaps[1].candidates = {{7, second, 100, 200, 200, 100, similarity}};
        const auto assignments = evidentialPolicy()->associate(overlaps, SemanticVoxelMap());
        return {assignments[0].instance, assignments[1].instance};
    }

    Opinion opinions[2];
    std::vector<OpinionOverlaps> overlaps;
};
using Ids = std::vector<instance_id_t>;
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
    EXPECT_EQ(TwoOpinions(100).assigned(80, 79, 0.3), (Ids{7, UNKNOWN_INSTANCE}));
    EXPECT_EQ(TwoOpinions(100).assigned(99, 80, 0.29), (Ids{UNKNOWN_INSTANCE, UNKNOWN_INSTANCE}));
}

TEST(EvidentialAssociation, WhatOverlapsLessButIsNamedAlikeIsPreferred)
{
    Opinion opinion;
    opinion.voxels.resize(100);
    OpinionOverlaps overlaps;
    overlaps.opinion = &opinion;
    overlaps.shared = {0};
    overlaps.candidates = {{3, 90, 100, 150, 150, 100, 0.1},   // 0.6 + 0.9 + 0.1
                           {8, 80, 100, 200, 200, 100, 0.5}};  // 0.4 + 0.8 + 0.5
    const auto assignments = evidentialPolicy()->associate({overlaps}, SemanticVoxelMap());
    EXPECT_EQ(assignments[0].instance, 8U);
}
