// SPDX-License-Identifier: BSD-3-Clause
#include "grid/RayPacket.h"

#include <gtest/gtest.h>
#include <mrpt/math/TPoint3D.h>

#include <random>
#include <vector>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
constexpr int32_t SHIFT = 1 << 20;  // keeps packed coordinates from becoming negative

uint64_t keyOf(const VoxelCoord& v)
{
    return packed(v + VoxelCoord{SHIFT, SHIFT, SHIFT});
}

/** Expects that a ray goes the same way among others as alone. */
void expectSameWay(const std::vector<TPoint3D>& from, const std::vector<TPoint3D>& to)
{
    RayPacket bundle;
    size_t longest = 0;
    for (size_t r = 0; r < RayPacket::RAYS; ++r) {
        const GridRay ray(from[r], to[r], 1);
        bundle.set(r, ray, keyOf(voxelOf(from[r], 1)));
        longest = std::max(longest, static_cast<size_t>(ray.steps) + 1);
    }
    // In two walks, the second of which goes on where the first one stopped.
    std::vector<uint64_t> keys(longest * RayPacket::RAYS);
    const size_t half = longest / 2;
    bundle.walk(half, keys.data());
    bundle.walk(longest - half, keys.data() + half * RayPacket::RAYS);
    for (size_t r = 0; r < RayPacket::RAYS; ++r) {
        size_t s = 0;
        traverseRay(from[r], to[r], 1, [&](const VoxelCoord& v) {
            ASSERT_EQ(keys[s++ * RayPacket::RAYS + r], keyOf(v)) << "ray " << r << ", step " << s;
        });
    }
}
}  // namespace

TEST(RayPacket, WalksEachRayAsTraverseRayDoes)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const double length : {0.8, 12.0, 300.0})
        for (int i = 0; i < 100; ++i) {
            std::vector<TPoint3D> from, to;
            for (size_t r = 0; r < RayPacket::RAYS; ++r) {
                from.emplace_back(any(random), any(random), any(random));
                to.push_back(TPoint3D(any(random), any(random), any(random)) * length);
            }
            expectSameWay(from, to);
        }
}

TEST(RayPacket, LetsShortRaysWaitForLongOnes)
{
    std::vector<TPoint3D> from(RayPacket::RAYS, TPoint3D(0.999, 0.999, 0.999)), to;
    for (size_t r = 0; r < RayPacket::RAYS; ++r)
        to.push_back(r % 2 == 0 ? TPoint3D(1.001, 1.0015, 1.002)
                                : TPoint3D(-9e3, 8e3, 1e3 * static_cast<double>(r)));
    expectSameWay(from, to);
}

TEST(RayPacket, KeepsToAxesEdgesAndCorners)
{
    const std::vector<TPoint3D> ends = {{3, 3, 3},     {-3, -3, -3}, {3, 0, 0},  {0, -3, 0},
                                        {0, 0, 3},     {-3, 0, 0},   {2, 1, -3}, {0, 0, 0},
                                        {-2, 3, 1},    {1, 1, 0},    {0, 1, 1},  {-1, 0, 1},
                                        {5, -5, 1e-9}, {1, 1, 4},    {-4, 1, 1}, {1e-9, 7, 0}};
    expectSameWay(std::vector<TPoint3D>(RayPacket::RAYS, TPoint3D(0, 0, 0)), ends);
    expectSameWay(std::vector<TPoint3D>(RayPacket::RAYS, TPoint3D(0.5, 0.5, 0.5)), ends);
    expectSameWay(ends, std::vector<TPoint3D>(RayPacket::RAYS, TPoint3D(-1, 2, 0.25)));
}
