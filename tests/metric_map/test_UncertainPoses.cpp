// SPDX-License-Identifier: BSD-3-Clause
/** What covariances of poses do to a map. */
#include "support/MapBytes.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace voxeland;

namespace
{
constexpr int FRAMES = 18, GOOD = 6;
constexpr double OFF_BY = 0.3;  // [m]

SemanticVoxelMap mapOf(const std::vector<test::SmallFrame>& frames, bool poseUncertainty)
{
    const test::TemporaryFolder folder;
    test::writeRawlog(folder.file("in.rawlog"), frames);
    const MapperConfig config(Ini::fromText(
        std::string("[map]\npose_uncertainty = ") + (poseUncertainty ? "true" : "false"), "test"));
    RawlogFrameSource source(folder.file("in.rawlog"), config.input, {});
    CVoxelandMap map(config);
    mapRawlog(source, map, [](const StageTimes&) {});
    return map.map();
}

/** Frames of which all but the first few stand at a wrong place. \param told whether they say so */
std::vector<test::SmallFrame> lostFrames(bool told)
{
    auto frames = test::smallFrames(FRAMES);
    for (int i = GOOD; i < FRAMES; ++i) {
        auto& pose = frames[static_cast<size_t>(i)].pose->pose;
        pose.mean.x_incr((i % 2 == 0 ? 1 : -1) * OFF_BY);
        if (told) pose.cov(0, 0) = OFF_BY * OFF_BY;
    }
    return frames;
}

std::set<std::tuple<int, int, int>> occupiedVoxels(const SemanticVoxelMap& map)
{
    std::set<std::tuple<int, int, int>> voxels;
    map.forEachVoxel([&](const VoxelCoord& v, auto&&...) { voxels.emplace(v.x, v.y, v.z); });
    return voxels;
}

/** Share of the occupied voxels of either map that both have. */
double similarity(const SemanticVoxelMap& a, const SemanticVoxelMap& b)
{
    const auto first = occupiedVoxels(a), second = occupiedVoxels(b);
    size_t common = 0;
    for (const auto& v : first) common += second.count(v);
    return static_cast<double>(common) / static_cast<double>(first.size() + second.size() - common);
}
}  // namespace

TEST(UncertainPoses, CovariancesCountForNothingUnlessAskedFor)
{
    EXPECT_EQ(test::bytesOf(mapOf(lostFrames(true), false)),
              test::bytesOf(mapOf(lostFrames(false), false)));
}

TEST(UncertainPoses, PosesWithoutCovarianceAreExact)
{
    EXPECT_EQ(test::bytesOf(mapOf(lostFrames(false), true)),
              test::bytesOf(mapOf(lostFrames(false), false)));
}

TEST(UncertainPoses, SpoilLessOfWhatWasSeenFromGoodOnes)
{
    auto good = test::smallFrames(GOOD);
    const SemanticVoxelMap truth = mapOf(good, false);
    const double trusting = similarity(mapOf(lostFrames(true), false), truth);
    const double doubting = similarity(mapOf(lostFrames(true), true), truth);
    EXPECT_GT(doubting, trusting + 0.1) << doubting << " instead of " << trusting;
}
