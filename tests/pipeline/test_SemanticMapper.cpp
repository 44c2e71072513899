// SPDX-License-Identifier: BSD-3-Clause
/** What frames without a detection do to an object that is in view. */
#include "support/Frames.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/pipeline/SemanticMapper.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
/** Voxels left of an object that is detected once, and then missed in frames of the same view.
 *  \param keys of section [map] */
size_t voxelsLeft(int framesMissed, const std::string& keys)
{
    SemanticMapper mapper(MapperConfig(
        Ini::fromText("[map]\n" + keys + "\n[refinement]\nmin_evidence = 0\n", "the test")));
    SemanticVoxelMap map(mapper.config().map);
    MappingCounts counts;
    for (int i = 0; i <= framesMissed; ++i) {
        const auto wall = test::makeScan([](int, int) { return 1.02; }, i);
        std::vector<InstancePrediction> detected;
        if (i == 0) detected = {test::prediction(test::rectangleMask(10, 10, 60, 50), "picture")};
        mapper.integrate(mapper.prepare({wall, test::makePredictions(detected, i), {}}), map,
                         counts);
    }
    return voxelsByWinner(map, true)[1].size();
}
}  // namespace

TEST(SemanticMapper, AnObjectInViewThatIsMissedStays)
{
    const size_t detected = voxelsLeft(0, "");
    EXPECT_GT(detected, 20U);
    // A missed point counts a fifth of a detected one: more than five frames outvote it.
    EXPECT_EQ(voxelsLeft(8, ""), detected);
    EXPECT_EQ(voxelsLeft(8, "missed_share = 1"), 0U);
    EXPECT_GT(voxelsLeft(4, "missed_share = 1"), detected / 2);
}

TEST(SemanticMapper, WhoWalkedThroughBeforeAFarWallLeaves)
{
    SemanticMapper mapper{MapperConfig()};
    SemanticVoxelMap map(mapper.config().map);
    MappingCounts counts;
    // The person stands at 2 m, in some columns only; the wall, at 6 m, is beyond max_depth.
    const auto integrate = [&](int frame, bool person) {
        const auto scan = test::makeScan(
            [&](int c, int) { return person && c > 25 && c < 55 ? 2.02 : 6.0; }, frame);
        std::vector<InstancePrediction> detected;
        if (person) detected = {test::prediction(test::rectangleMask(26, 5, 55, 55), "person")};
        mapper.integrate(mapper.prepare({scan, test::makePredictions(detected, frame), {}}), map,
                         counts);
    };
    const auto occupied = [&] {
        size_t count = 0;
        for (const auto& [winner, voxels] : voxelsByWinner(map, true)) count += voxels.size();
        return count;
    };
    for (int i = 0; i < 5; ++i) integrate(i, true);
    EXPECT_GT(occupied(), 300U);
    for (int i = 5; i < 25; ++i) integrate(i, false);
    EXPECT_EQ(occupied(), 0U);
}
