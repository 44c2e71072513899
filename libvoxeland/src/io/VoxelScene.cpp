// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelScene.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

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

/** The map's axes seen from a frame that has `up` as its z axis. */
std::array<cv::Vec3f, 3> levelledAxes(const mrpt::math::TVector3D& up)
{
    const cv::Vec3f z = cv::normalize(
        cv::Vec3f(static_cast<float>(up.x), static_cast<float>(up.y), static_cast<float>(up.z)));
    const cv::Vec3f ahead = std::abs(z[0]) < 0.9F ? cv::Vec3f(1, 0, 0) : cv::Vec3f(0, 1, 0);
    const cv::Vec3f x = cv::normalize(ahead - z * ahead.dot(z));
    const cv::Vec3f y = z.cross(x);
    return {cv::Vec3f(x[0], y[0], z[0]), {x[1], y[1], z[1]}, {x[2], y[2], z[2]}};
}
}  // namespace

VoxelScene::VoxelScene(const SemanticVoxelMap& map, const mrpt::math::TVector3D& up)
    : m_resolution(map.resolution()), m_axes(levelledAxes(up))
{
    std::vector<VoxelCoord> coords;
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const auto p = voxelCenter<mrpt::math::TPoint3Df>(v, m_resolution);
        m_voxels.push_back(
            {m_axes[0] * p.x + m_axes[1] * p.y + m_axes[2] * p.z, &evidence, evidence.winner(), 0});
        coords.push_back(v);
    });
    if (m_voxels.empty()) return;

    const float cut = cutHeight();
    std::unordered_map<uint64_t, bool> isObject;
    size_t kept = 0;
    for (size_t i = 0; i < m_voxels.size(); ++i) {
        if (!m_voxels[i].isObject() && m_voxels[i].center[2] > cut) continue;
        isObject[packed(coords[i])] = m_voxels[i].isObject();
        m_voxels[kept] = m_voxels[i];
        coords[kept++] = coords[i];
    }
    m_voxels.resize(kept);
    for (size_t i = 0; i < kept; ++i)
        for (size_t f = 0; f < FACES.size(); ++f) {
            const auto at = isObject.find(packed(coords[i] + FACES[f]));
            const bool covered = at != isObject.end() && at->second == m_voxels[i].isObject();
            if (!covered) m_voxels[i].exposedFaces |= static_cast<uint8_t>(1U << f);
        }
    findBounds();
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
