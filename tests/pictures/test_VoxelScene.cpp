// SPDX-License-Identifier: BSD-3-Clause
/** What of a map is drawn, against a look at every voxel. */
#include "pictures/VoxelScene.h"
#include "support/TinyMap.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
constexpr instance_id_t NOTHING = ~instance_id_t{0};

/** Voxels at random across the borders of blocks: two instances, unknown, and some free again. */
SemanticVoxelMap scattered(unsigned seed)
{
    SemanticVoxelMap map = emptyMap();
    const instance_id_t a = addInstance(map, {{"chair", 2}}), b = addInstance(map, {{"cup", 2}});
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> anywhere(-9, 9), which(0, 3);
    for (int i = 0; i < 1500; ++i) {
        const int x = anywhere(random), y = anywhere(random), z = anywhere(random) / 3;
        const int kind = which(random);
        const instance_id_t id = kind == 0 ? a : kind == 1 ? b : UNKNOWN_INSTANCE;
        addVoxel(map, {x, y, z}, {{id, 1}}, kind == 3 ? 0.2 : 0.9);
    }
    return map;
}

/** Who wins a voxel, NOTHING if it is not occupied. */
instance_id_t winnerAt(const SemanticVoxelMap& map, const VoxelCoord& v)
{
    const VoxelEvidence* evidence = map.evidence(v);
    const bool occupied = evidence != nullptr && OccupancyFilter::isOccupied(map.occupancy(v));
    return occupied ? map.winner(*evidence) : NOTHING;
}

/** Those of a map's voxels that a scene should show with their faces, found one by one.
 *  \param shown (coordinates, winner) -> as what, NOTHING if not */
template <typename Shown>
std::set<std::tuple<VoxelCoord, instance_id_t, int>> expected(const SemanticVoxelMap& map,
                                                              Shown&& shown)
{
    const auto at = [&](const VoxelCoord& v) {
        const instance_id_t winner = winnerAt(map, v);
        return winner == NOTHING ? NOTHING : shown(v, winner);
    };
    std::set<std::tuple<VoxelCoord, instance_id_t, int>> voxels;
    for (int z = -12; z <= 12; ++z)
        for (int y = -12; y <= 12; ++y)
            for (int x = -12; x <= 12; ++x) {
                const instance_id_t as = at({x, y, z});
                if (as == NOTHING) continue;
                int faces = 0;
                for (size_t f = 0; f < FACES.size(); ++f) {
                    const instance_id_t beyond = at(VoxelCoord{x, y, z} + FACES[f]);
                    const bool covered = beyond != NOTHING &&
                                         (beyond != UNKNOWN_INSTANCE) == (as != UNKNOWN_INSTANCE);
                    faces |= covered ? 0 : 1 << f;
                }
                voxels.emplace(VoxelCoord{x, y, z}, as, faces);
            }
    return voxels;
}

/** The voxels of a scene in the map's own frame. */
std::set<std::tuple<VoxelCoord, instance_id_t, int>> voxelsOf(const VoxelScene& scene)
{
    std::set<std::tuple<VoxelCoord, instance_id_t, int>> voxels;
    for (const SceneVoxel& v : scene.voxels()) {
        const mrpt::math::TPoint3D center(v.center[0], v.center[1], v.center[2]);
        voxels.emplace(voxelOf(center, 1 / TINY_RESOLUTION), v.winner, v.exposedFaces);
    }
    return voxels;
}
}  // namespace

TEST(VoxelScene, HasTheVoxelsBelowTheCutAndTheirOpenFaces)
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        const SemanticVoxelMap map = scattered(seed);
        const VoxelScene scene(map, GravityAlignedFrame());
        // The cut lies above 95 % of the objects' voxels, here in the highest layer, z = 3.
        std::vector<float> heights;
        for (const SceneVoxel& v : scene.voxels())
            if (v.isObject()) heights.push_back(v.center[2]);
        std::sort(heights.begin(), heights.end());
        const size_t n = static_cast<size_t>(std::ceil(0.95 * double(heights.size() - 1)));
        const float cut = heights[n] + static_cast<float>(TINY_RESOLUTION);
        const auto shown = [&](const VoxelCoord& v, instance_id_t winner) {
            const double height = (v.z + 0.5) * TINY_RESOLUTION;
            return winner == UNKNOWN_INSTANCE && height > static_cast<double>(cut) ? NOTHING
                                                                                   : winner;
        };
        EXPECT_EQ(voxelsOf(scene), expected(map, shown)) << seed;
        EXPECT_EQ(scene.voxels().size(), voxelsOf(scene).size());
    }
}

TEST(VoxelScene, OfAnInstanceHasItsSurroundingsAndNoOtherObject)
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        SemanticVoxelMap map = scattered(seed);
        const instance_id_t cup = addInstance(map, {{"cup", 2}});
        addVoxel(map, {7, 7, 1}, {{cup, 100}});  // at the border of a block: 7 | 8
        addVoxel(map, {8, 7, 1}, {{cup, 100}});
        const VoxelScene scene(map, GravityAlignedFrame(), cup);
        // Its box is 0.2 m long, so 0.2 m around it are shown: two voxels each way.
        const auto shown = [&](const VoxelCoord& v, instance_id_t winner) {
            const bool inside =
                v.x >= 5 && v.x <= 10 && v.y >= 5 && v.y <= 9 && v.z >= -1 && v.z <= 3;
            return !inside ? NOTHING : winner == cup ? cup : UNKNOWN_INSTANCE;
        };
        EXPECT_EQ(voxelsOf(scene), expected(map, shown)) << seed;
    }
}

TEST(VoxelScene, OfAnInstanceAtBothEndsOfTheMapCostsNoMoreThanTheMap)
{
    SemanticVoxelMap map = emptyMap();
    const instance_id_t far = addInstance(map, {{"chair", 2}});
    addVoxel(map, {-MAX_VOXEL_COORD, -MAX_VOXEL_COORD, 0}, {{far, 1}});
    addVoxel(map, {MAX_VOXEL_COORD, MAX_VOXEL_COORD, 0}, {{far, 1}});
    addVoxel(map, {3, 3, 0}, {{UNKNOWN_INSTANCE, 1}});
    const VoxelScene scene(map, GravityAlignedFrame(), far);
    EXPECT_EQ(scene.voxels().size(), 3U);
}

TEST(VoxelScene, OfAnInstanceWithoutVoxelsIsEmpty)
{
    SemanticVoxelMap map = tinyMap();
    const VoxelScene scene(map, GravityAlignedFrame(), addInstance(map, {{"cup", 1}}));
    EXPECT_TRUE(scene.voxels().empty());
}
