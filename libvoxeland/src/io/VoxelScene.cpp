// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelScene.h"

#include "voxeland/grid/CoordHash.h"

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

cv::Vec3f toCv(const mrpt::math::TPoint3D& p)
{
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}
}  // namespace

VoxelScene::VoxelScene(const SemanticVoxelMap& map, const LevelFrame& frame)
    : m_resolution(map.resolution()),
      m_frame(frame),
      m_axes({toLevel({1, 0, 0}), toLevel({0, 1, 0}), toLevel({0, 0, 1})})
{
    collect(map);
    if (m_voxels.empty()) return;
    const float cut = cutHeight();
    keepIf([cut](const SceneVoxel& v) { return v.isObject() || v.center[2] <= cut; });
    findExposedFaces();
    findBounds();
}

VoxelScene::VoxelScene(const SemanticVoxelMap& map, const LevelFrame& frame, instance_id_t instance,
                       double surroundings)
    : m_resolution(map.resolution()),
      m_frame(frame),
      m_axes({toLevel({1, 0, 0}), toLevel({0, 1, 0}), toLevel({0, 0, 1})})
{
    collect(map);
    keepIf([instance](const SceneVoxel& v) { return v.winner == instance; });
    if (m_voxels.empty()) return;
    findBounds();
    const auto reach = static_cast<float>(surroundings);
    m_min -= cv::Vec3f::all(reach);
    m_max += cv::Vec3f::all(reach);
    m_voxels.clear();
    m_coords.clear();
    collect(map);
    keepIf([this](const SceneVoxel& v) {
        for (int a = 0; a < 3; ++a)
            if (v.center[a] < m_min[a] || v.center[a] > m_max[a]) return false;
        return true;
    });
    for (SceneVoxel& v : m_voxels)
        if (v.winner != instance) v.winner = UNKNOWN_INSTANCE;
    findExposedFaces();
}

void VoxelScene::collect(const SemanticVoxelMap& map)
{
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const cv::Vec3f center = toLevel(voxelCenter<mrpt::math::TPoint3D>(v, m_resolution));
        m_voxels.push_back({center, &evidence, map.winner(evidence), 0});
        m_coords.push_back(v);
    });
}

template <typename F>
void VoxelScene::keepIf(F&& keep)
{
    size_t kept = 0;
    for (size_t i = 0; i < m_voxels.size(); ++i) {
        if (!keep(m_voxels[i])) continue;
        m_voxels[kept] = m_voxels[i];
        m_coords[kept++] = m_coords[i];
    }
    m_voxels.resize(kept);
    m_coords.resize(kept);
}

void VoxelScene::findExposedFaces()
{
    CoordHash index;
    index.reserve(m_voxels.size());
    for (size_t i = 0; i < m_voxels.size(); ++i)
        index.insert(m_coords[i], static_cast<uint32_t>(i));
    for (size_t i = 0; i < m_voxels.size(); ++i)
        for (size_t f = 0; f < FACES.size(); ++f) {
            const uint32_t beyond = index.find(m_coords[i] + FACES[f]);
            const bool covered =
                beyond != CoordHash::NONE && m_voxels[beyond].isObject() == m_voxels[i].isObject();
            if (!covered) m_voxels[i].exposedFaces |= static_cast<uint8_t>(1U << f);
        }
    m_coords.clear();
}

cv::Vec3f VoxelScene::toLevel(const mrpt::math::TPoint3D& inMap) const
{
    return toCv(m_frame.toLevel(inMap));
}

float VoxelScene::cutHeight() const
{
    std::vector<float> all, objects;
    for (const SceneVoxel& v : m_voxels) {
        all.push_back(v.center[2]);
        if (v.isObject()) objects.push_back(v.center[2]);
    }
    const auto edge = static_cast<float>(m_resolution);
    if (!objects.empty()) return quantile(objects, OBJECTS_BELOW_CUT) + edge;
    const float low = quantile(all, STRAYS), high = quantile(all, 1 - STRAYS);
    return low + static_cast<float>(HEIGHT_WITHOUT_OBJECTS) * (high - low) + edge / 2;
}

void VoxelScene::findBounds()
{
    const auto half = static_cast<float>(m_resolution / 2);
    for (int a = 0; a < 3; ++a) {
        std::vector<float> values;
        for (const SceneVoxel& v : m_voxels) values.push_back(v.center[a]);
        m_min[a] = quantile(values, STRAYS) - half;
        m_max[a] = quantile(values, 1 - STRAYS) + half;
    }
}
}  // namespace voxeland
