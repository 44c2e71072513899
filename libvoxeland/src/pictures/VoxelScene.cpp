// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelScene.h"

#include <mrpt/math/TBoundingBox.h>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
constexpr double OBJECTS_BELOW_CUT = 0.95, HEIGHT_WITHOUT_OBJECTS = 0.9;
constexpr double STRAYS = 0.002;  //!< share of the voxels left out of the bounds on each side

/** \param values not empty; reordered. Rounds outwards: few values lose none. */
float quantile(std::vector<float>& values, double share)
{
    const double place = share * static_cast<double>(values.size() - 1);
    const auto n = static_cast<long>(share < 0.5 ? std::floor(place) : std::ceil(place));
    std::nth_element(values.begin(), values.begin() + n, values.end());
    return values[static_cast<size_t>(n)];
}

/** How much of what is around an instance tells what stands in it [m]. \param size of its box */
float surroundingsOf(const cv::Vec3f& size)
{
    const double longest = static_cast<double>(std::max({size[0], size[1], size[2]}));
    return static_cast<float>(std::clamp(0.3 * longest, 0.2, 0.6));
}

cv::Vec3f toCv(const mrpt::math::TPoint3D& p)
{
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}
}  // namespace

VoxelScene::VoxelScene(double resolution, const GravityAlignedFrame& frame)
    : m_resolution(resolution),
      m_frame(frame),
      m_axes({toLevel({1, 0, 0}), toLevel({0, 1, 0}), toLevel({0, 0, 1})})
{
}

VoxelScene::VoxelScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame)
    : VoxelScene(map.resolution(), frame)
{
    const float cut = cutHeight(map);
    const Shown shown = [&](const VoxelCoord& v,
                            const VoxelEvidence& evidence) -> std::optional<instance_id_t> {
        const instance_id_t winner = map.winner(evidence);
        if (winner == UNKNOWN_INSTANCE && centerOf(v)[2] > cut) return std::nullopt;
        return winner;
    };
    m_voxels.reserve(map.memory().surfaceVoxels);
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        add(map, v, evidence, shown);
    });
    findBounds();
}

VoxelScene::VoxelScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                       instance_id_t instance)
    : VoxelScene(map.resolution(), frame)
{
    using Found = std::optional<instance_id_t>;
    addBlocks(map, map.instance(instance).blocks, [&](const VoxelCoord&, const auto& evidence) {
        return map.winner(evidence) == instance ? Found(instance) : std::nullopt;
    });
    if (m_voxels.empty()) return;
    findBounds();
    const auto reach = surroundingsOf(m_max - m_min);
    m_min -= cv::Vec3f::all(reach);
    m_max += cv::Vec3f::all(reach);
    m_voxels.clear();
    addBlocks(map, blocksInBounds(map), [&](const VoxelCoord& v, const auto& evidence) {
        if (!isInBounds(centerOf(v))) return Found();
        return Found(map.winner(evidence) == instance ? instance : UNKNOWN_INSTANCE);
    });
}

void VoxelScene::add(const SemanticVoxelMap& map, const VoxelCoord& v,
                     const VoxelEvidence& evidence, const Shown& shown)
{
    const auto winner = shown(v, evidence);
    if (!winner) return;
    SceneVoxel voxel{centerOf(v), &evidence, *winner, 0};
    for (size_t f = 0; f < FACES.size(); ++f) {
        const VoxelCoord beyond = v + FACES[f];
        const VoxelEvidence* other = map.evidence(beyond);
        const auto cover = other != nullptr && OccupancyFilter::isOccupied(map.occupancy(beyond))
                               ? shown(beyond, *other)
                               : std::nullopt;
        const bool covered = cover && (*cover != UNKNOWN_INSTANCE) == voxel.isObject();
        if (!covered) voxel.exposedFaces |= static_cast<uint8_t>(1U << f);
    }
    m_voxels.push_back(voxel);
}

template <typename Coords>
void VoxelScene::addBlocks(const SemanticVoxelMap& map, const Coords& blocks, const Shown& shown)
{
    for (const VoxelCoord& b : blocks) {
        const MapBlock* block = map.blocks().find(b);
        if (block == nullptr) continue;
        block->forEachSurface([&](int cell, const VoxelEvidence& evidence) {
            if (OccupancyFilter::isOccupied(block->occupancy(cell)))
                add(map, voxelAt(b, cell), evidence, shown);
        });
    }
}

std::vector<VoxelCoord> VoxelScene::blocksInBounds(const SemanticVoxelMap& map) const
{
    mrpt::math::TBoundingBox box = mrpt::math::TBoundingBox::PlusMinusInfinity();
    for (const float x : {m_min[0], m_max[0]})
        for (const float y : {m_min[1], m_max[1]})
            for (const float z : {m_min[2], m_max[2]})
                box.updateWithPoint(m_frame.toMap({x, y, z}));
    const VoxelCoord first = blockOf(voxelOf(box.min, 1 / m_resolution)),
                     last = blockOf(voxelOf(box.max, 1 / m_resolution));
    const auto isBetween = [](int32_t low, int32_t n, int32_t high) {
        return low <= n && n <= high;
    };
    const auto edge = [](int32_t low, int32_t high) { return static_cast<double>(high - low) + 1; };
    std::vector<VoxelCoord> blocks;
    if (edge(first.x, last.x) * edge(first.y, last.y) * edge(first.z, last.z) >
        static_cast<double>(map.blocks().size()))
    {
        for (const uint32_t b : map.blocks().sorted()) {
            const VoxelCoord& c = map.blocks().coordOf(b);
            if (isBetween(first.x, c.x, last.x) && isBetween(first.y, c.y, last.y) &&
                isBetween(first.z, c.z, last.z))
                blocks.push_back(c);
        }
        return blocks;
    }
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) blocks.push_back({x, y, z});
    return blocks;
}

bool VoxelScene::isInBounds(const cv::Vec3f& point) const
{
    for (int a = 0; a < 3; ++a)
        if (point[a] < m_min[a] || point[a] > m_max[a]) return false;
    return true;
}

cv::Vec3f VoxelScene::toLevel(const mrpt::math::TPoint3D& inMap) const
{
    return toCv(m_frame.toLevel(inMap));
}

cv::Vec3f VoxelScene::centerOf(const VoxelCoord& v) const
{
    return toLevel(voxelCenter<mrpt::math::TPoint3D>(v, m_resolution));
}

float VoxelScene::cutHeight(const SemanticVoxelMap& map) const
{
    std::vector<float> all, objects;
    all.reserve(map.memory().surfaceVoxels);
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const float height = centerOf(v)[2];
        all.push_back(height);
        if (map.winner(evidence) != UNKNOWN_INSTANCE) objects.push_back(height);
    });
    if (all.empty()) return 0;
    const auto edge = static_cast<float>(m_resolution);
    if (!objects.empty()) return quantile(objects, OBJECTS_BELOW_CUT) + edge;
    const float low = quantile(all, STRAYS), high = quantile(all, 1 - STRAYS);
    return low + static_cast<float>(HEIGHT_WITHOUT_OBJECTS) * (high - low) + edge / 2;
}

void VoxelScene::findBounds()
{
    if (m_voxels.empty()) return;
    const auto half = static_cast<float>(m_resolution / 2);
    for (int a = 0; a < 3; ++a) {
        std::vector<float> values;
        values.reserve(m_voxels.size());
        for (const SceneVoxel& v : m_voxels) values.push_back(v.center[a]);
        m_min[a] = quantile(values, STRAYS) - half;
        m_max[a] = quantile(values, 1 - STRAYS) + half;
    }
}
}  // namespace voxeland
