// SPDX-License-Identifier: BSD-3-Clause
#include "UncertainMap.h"
#include "disambiguation/UncertainInstance.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
/** No prior, entropy of the mean: easy to reckon. */
SemanticVoxelMap emptyMap()
{
    MapOptions options;
    options.prior_strength = 0;
    options.entropy = EntropyMeasure::mean;
    return SemanticVoxelMap(options);
}

DisambiguationOptions above(double threshold)
{
    DisambiguationOptions options;
    options.entropy_threshold = threshold;
    options.min_voxels = 20;
    return options;
}

std::vector<instance_id_t> idsOf(const SemanticVoxelMap& map, const DisambiguationOptions& options)
{
    std::vector<instance_id_t> ids;
    for (const auto& u : uncertainInstances(map, options)) ids.push_back(u.id);
    return ids;
}
using Ids = std::vector<instance_id_t>;
}  // namespace

TEST(UncertainInstances, TheMostUncertainFirstAndOnlyThoseAboveTheThreshold)
{
    auto map = emptyMap();
    test::addInstance(map, 9, 1, 0);  // 0.325
    test::addInstance(map, 1, 1, 0);  // 0.693
    test::addInstance(map, 1, 1, 1);  // 1.099
    EXPECT_EQ(idsOf(map, above(0.3)), (Ids{3, 2, 1}));
    EXPECT_EQ(idsOf(map, above(0.5)), (Ids{3, 2}));
    EXPECT_EQ(idsOf(map, above(2)), Ids{});
    auto options = above(0.3);
    options.max_questions = 1;
    EXPECT_EQ(idsOf(map, options), (Ids{3}));
}

TEST(UncertainInstances, SmallOnesDecidedOnesAndUnseenOnesAreLeftOut)
{
    auto map = emptyMap();
    const auto small = test::addInstance(map, 1, 1, 0, 19),
               decided = test::addInstance(map, 1, 1, 0), unseen = test::addInstance(map, 1, 1, 0),
               asked = test::addInstance(map, 1, 1, 0);
    Decision decision;
    decision.category = 0;
    decision.evidence = 0.001;
    map.instance(decided).decisions.push_back(decision);
    map.instance(unseen).views = {};
    EXPECT_EQ(idsOf(map, above(0.5)), (Ids{asked}));
    EXPECT_EQ(countTooSmallToAsk(map, above(0.5)), 1U);
    EXPECT_EQ(countTooSmallToAsk(map, above(0.7)), 0U) << "small but certain";
    auto options = above(0.5);
    options.min_voxels = 31;
    EXPECT_EQ(countTooSmallToAsk(map, options), 3U) << "all but the decided one";
    options.ask_again = true;
    EXPECT_EQ(countTooSmallToAsk(map, options), 4U);
    options.min_voxels = 19;
    EXPECT_EQ(idsOf(map, options), (Ids{small, asked, decided}));
}

TEST(UncertainInstances, CandidatesAreTheLikeliestThatADetectorNamedEachWithItsViews)
{
    auto map = emptyMap();
    map.setOptions([] {
        MapOptions options;
        options.prior_strength = 4;
        return options;
    }());
    test::addInstance(map, 3, 5, 0);
    auto options = above(0.1);
    const auto uncertain = uncertainInstances(map, options);
    ASSERT_EQ(uncertain.size(), 1U);
    ASSERT_EQ(uncertain[0].candidates.size(), 2U) << "the prior alone makes no candidate";
    EXPECT_EQ(uncertain[0].candidates[0].name, "couch");
    EXPECT_EQ(uncertain[0].candidates[1].name, "chair");
    ASSERT_EQ(uncertain[0].views.size(), 2U);
    EXPECT_EQ(uncertain[0].views[0].view.frame, 11U);
    EXPECT_EQ(uncertain[0].views[1].view.frame, 10U);
    options.max_categories = 1;
    EXPECT_EQ(uncertainInstances(map, options)[0].views.size(), 1U);
}
