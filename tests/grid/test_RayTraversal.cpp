// SPDX-License-Identifier: BSD-3-Clause
#include "grid/RayTraversal.h"

#include <gtest/gtest.h>
#include <mrpt/math/TPoint3D.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
std::vector<VoxelCoord> traversed(const TPoint3D& from, const TPoint3D& to, double resolution)
{
    std::vector<VoxelCoord> voxels;
    traverseRay(from, to, 1 / resolution, [&](const VoxelCoord& v) { voxels.push_back(v); });
    return voxels;
}

/** Length of the part of a segment inside a voxel, by clipping it against the six planes. */
double lengthInside(const TPoint3D& from, const TPoint3D& to, const VoxelCoord& v,
                    double resolution)
{
    const double low[3] = {v.x * resolution, v.y * resolution, v.z * resolution};
    double enter = 0, leave = 1;
    for (size_t a = 0; a < 3; ++a) {
        const double d = to[a] - from[a], high = low[a] + resolution;
        if (d == 0) {
            if (from[a] < low[a] || from[a] >= high) return 0;
            continue;
        }
        const double t0 = (low[a] - from[a]) / d, t1 = (high - from[a]) / d;
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
    }
    return leave > enter ? (leave - enter) * (to - from).norm() : 0;
}

void expectExact(const TPoint3D& from, const TPoint3D& to, double resolution)
{
    const auto voxels = traversed(from, to, resolution);
    ASSERT_FALSE(voxels.empty());
    EXPECT_EQ(voxels.front(), voxelOf(from, 1 / resolution));
    EXPECT_EQ(voxels.back(), voxelOf(to, 1 / resolution));
    for (size_t i = 1; i < voxels.size(); ++i) {
        const VoxelCoord &a = voxels[i - 1], &b = voxels[i];
        ASSERT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z), 1)
            << "successive voxels must share a face";
    }
    VoxelCoord least = voxels.front(), most = least;
    for (const auto& v : {voxels.front(), voxels.back()}) {
        least = {std::min(least.x, v.x), std::min(least.y, v.y), std::min(least.z, v.z)};
        most = {std::max(most.x, v.x), std::max(most.y, v.y), std::max(most.z, v.z)};
    }
    constexpr double TOUCHES_ONLY = 1e-9;  // [m]
    for (int z = least.z; z <= most.z; ++z)
        for (int y = least.y; y <= most.y; ++y)
            for (int x = least.x; x <= most.x; ++x) {
                const VoxelCoord v = {x, y, z};
                if (lengthInside(from, to, v, resolution) < TOUCHES_ONLY) continue;
                ASSERT_EQ(std::count(voxels.begin(), voxels.end(), v), 1)
                    << x << " " << y << " " << z;
            }
}
}  // namespace

TEST(RayTraversal, VisitsEveryVoxelARandomSegmentPasses)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 300; ++i)
        expectExact({any(random), any(random), any(random)},
                    {any(random), any(random), any(random)}, 0.1);
}

TEST(RayTraversal, VisitsNoVoxelThatTheSegmentMisses)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-2, 2);
    for (int i = 0; i < 300; ++i) {
        const TPoint3D from(any(random), any(random), any(random)),
            to(any(random), any(random), any(random));
        for (const VoxelCoord& v : traversed(from, to, 0.07))
            ASSERT_GT(lengthInside(from, to, v, 0.07), 0);
    }
}

TEST(RayTraversal, FollowsAxesInBothDirections)
{
    for (size_t axis = 0; axis < 3; ++axis) {
        TPoint3D from(0.12, -0.34, 0.56), to = from;
        to[axis] += 1.5;
        expectExact(from, to, 0.1);
        expectExact(to, from, 0.1);
        EXPECT_EQ(traversed(from, to, 0.1).size(), 16u);
    }
}

TEST(RayTraversal, PassesThroughEdgesAndCorners)
{
    const auto diagonal = traversed({0.5, 0.5, 0.5}, {3.5, 3.5, 3.5}, 1);
    EXPECT_EQ(diagonal.size(), 10u);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(std::count(diagonal.begin(), diagonal.end(), VoxelCoord{i, i, i}), 1);
    expectExact({-0.5, -0.5, -0.5}, {2.5, 2.5, 2.5}, 1);
    expectExact({2.5, 0.5, -1.5}, {-1.5, -3.5, -1.5}, 1);
    expectExact({0, 0, 0}, {2, 1, -3}, 1);    // starts and ends in corners
    expectExact({-2, 3, 1}, {-2, -3, 1}, 1);  // runs along an edge
    expectExact({1, 1, 1}, {-1, -1, -1}, 1);
}

TEST(RayTraversal, SegmentWithinOneVoxelVisitsItOnce)
{
    EXPECT_EQ(traversed({-0.01, 0.02, 0.03}, {-0.01, 0.02, 0.03}, 0.05).size(), 1u);
    EXPECT_EQ(traversed({0.01, 0.01, 0.01}, {0.04, 0.02, 0.03}, 0.05),
              (std::vector<VoxelCoord>{{0, 0, 0}}));
}

TEST(RayTraversal, LongRaysNeverMissTheLastVoxel)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-500, 500);
    for (int i = 0; i < 200; ++i) {
        const TPoint3D from(any(random), any(random), any(random)),
            to(any(random), any(random), any(random));
        EXPECT_EQ(traversed(from, to, 0.05).back(), voxelOf(to, 1 / 0.05));
    }
}
