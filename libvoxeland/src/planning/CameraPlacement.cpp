// SPDX-License-Identifier: BSD-3-Clause
#include "CameraPlacement.h"

#include "grid/RayTraversal.h"
#include "level/LevelPose.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
constexpr double DEGREE = M_PI / 180;
constexpr int DIRECTIONS = 32;     //!< tried around what is looked at
constexpr size_t LOOKED_AT = 100;  //!< voxels whose visibility is checked
constexpr double MARGIN = 1.2;     //!< how much farther away than where it just fits
constexpr double APART = 45 * DEGREE;
constexpr double LEAST_VISIBLE = 0.2;

/** What is looked at. */
class Target
{
 public:
    Target(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
           const std::vector<VoxelCoord>& voxels)
        : m_map(map)
    {
        TPoint3D low = level(frame, voxels[0]), high = low;
        for (const VoxelCoord& v : voxels) {
            m_voxels.insert(packed(v));
            const TPoint3D p = level(frame, v);
            for (size_t a = 0; a < 3; ++a) {
                low[a] = std::min(low[a], p[a]);
                high[a] = std::max(high[a], p[a]);
            }
        }
        m_middle = (low + high) * 0.5;
        m_radius = (high - low).norm() / 2 + map.resolution();
        const size_t step = (voxels.size() + LOOKED_AT - 1) / LOOKED_AT;
        for (size_t i = 0; i < voxels.size(); i += step) m_checked.push_back(voxels[i]);
    }

    /** Of the box around it, in the gravity-aligned frame [m]. */
    [[nodiscard]] const TPoint3D& middle() const { return m_middle; }
    /** Of a ball around it [m]. */
    [[nodiscard]] double radius() const { return m_radius; }

    /** Share of its voxels that nothing hides. \param eye in the map's frame */
    [[nodiscard]] double visibleFrom(const TPoint3D& eye) const
    {
        const auto seen = std::count_if(m_checked.begin(), m_checked.end(),
                                        [&](const VoxelCoord& v) { return isVisible(eye, v); });
        return static_cast<double>(seen) / static_cast<double>(m_checked.size());
    }

 private:
    [[nodiscard]] TPoint3D level(const GravityAlignedFrame& frame, const VoxelCoord& v) const
    {
        return frame.toLevel(voxelCenter<TPoint3D>(v, m_map.resolution()));
    }

    [[nodiscard]] bool isVisible(const TPoint3D& eye, const VoxelCoord& voxel) const
    {
        bool reached = false, hidden = false;
        traverseRay(eye, voxelCenter<TPoint3D>(voxel, m_map.resolution()), 1 / m_map.resolution(),
                    [&](const VoxelCoord& v) {
                        reached = reached || m_voxels.count(packed(v)) > 0;
                        hidden =
                            hidden || (!reached && !OccupancyFilter::isFree(m_map.occupancy(v)));
                    });
        return !hidden;
    }

    const SemanticVoxelMap& m_map;
    std::unordered_set<uint64_t> m_voxels;
    std::vector<VoxelCoord> m_checked;
    TPoint3D m_middle;
    double m_radius = 0;
};

/** Whether somebody can stand at a place and hold the camera there. */
bool canStand(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
              const CarriedCamera& camera, const TPoint3D& eye, double floor)
{
    constexpr double ABOVE_FLOOR = 0.15;
    const double edge = map.resolution();
    if (!OccupancyFilter::isFree(map.occupancyAt(frame.toMap(eye)))) return false;
    for (double z = floor + ABOVE_FLOOR; z <= eye.z; z += edge)
        for (double y = -camera.bodyRadius; y <= camera.bodyRadius; y += edge)
            for (double x = -camera.bodyRadius; x <= camera.bodyRadius; x += edge) {
                if (std::hypot(x, y) > camera.bodyRadius) continue;
                const TPoint3D p = frame.toMap({eye.x + x, eye.y + y, z});
                if (OccupancyFilter::isOccupied(map.occupancyAt(p))) return false;
            }
    return true;
}

/** Looking from a place at another. \param eye, at in the gravity-aligned frame */
CameraPose poseTowards(const GravityAlignedFrame& frame, const TPoint3D& eye, const TPoint3D& at)
{
    const TPoint3D way = at - eye;
    CameraPose result;
    result.yaw = std::atan2(way.y, way.x);
    result.pitch = std::atan2(-way.z, std::hypot(way.x, way.y));
    result.distance = way.norm();
    result.pose = poseOf(frame, {0, 0, 0}) +
                  mrpt::poses::CPose3D(eye.x, eye.y, eye.z, result.yaw, result.pitch, 0);
    return result;
}

/** All places to look at a target from. */
std::vector<CameraPose> candidates(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                                   const CarriedCamera& camera, double floor, const Target& target)
{
    const double angle = std::min(camera.horizontalAngle, camera.verticalAngle) / 2 * DEGREE;
    const double framing = MARGIN * target.radius() / std::sin(angle);
    const double rise = floor + camera.height - target.middle().z;
    std::vector<CameraPose> poses;
    for (const double factor : {1.0, 1.25, 1.6})
        for (int i = 0; i < DIRECTIONS; ++i) {
            const double distance =
                std::clamp(framing * factor, camera.minDistance, camera.maxDistance);
            if (distance <= std::abs(rise)) continue;
            const double level = std::sqrt(distance * distance - rise * rise);
            const double azimuth = 2 * M_PI * i / DIRECTIONS;
            const TPoint3D eye = target.middle() + TPoint3D(level * std::cos(azimuth),
                                                            level * std::sin(azimuth), rise);
            if (!canStand(map, frame, camera, eye, floor)) continue;
            poses.push_back(poseTowards(frame, eye, target.middle()));
            poses.back().visible = target.visibleFrom(frame.toMap(eye));
        }
    return poses;
}
}  // namespace

std::vector<CameraPose> placeCamera(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                                    const CarriedCamera& camera, double floor,
                                    const std::vector<VoxelCoord>& voxels, size_t most)
{
    std::vector<CameraPose> poses =
        candidates(map, frame, camera, floor, Target(map, frame, voxels));
    std::stable_sort(poses.begin(), poses.end(), [](const CameraPose& a, const CameraPose& b) {
        return a.visible > b.visible;
    });
    std::vector<CameraPose> chosen;
    for (const CameraPose& p : poses) {
        if (p.visible < LEAST_VISIBLE || chosen.size() >= most) break;
        const auto isNear = [&](const CameraPose& other) {
            return std::abs(std::remainder(p.yaw - other.yaw, 2 * M_PI)) < APART - 1e-6;
        };
        if (std::none_of(chosen.begin(), chosen.end(), isNear)) chosen.push_back(p);
    }
    return chosen;
}
}  // namespace voxeland
