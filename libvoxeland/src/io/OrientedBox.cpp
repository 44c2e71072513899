// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/OrientedBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland
{
namespace
{
/** Smallest and largest of some numbers. */
struct Range
{
    double min = std::numeric_limits<double>::infinity(), max = -min;

    void extend(double x)
    {
        min = std::min(min, x);
        max = std::max(max, x);
    }
    [[nodiscard]] double middle() const { return (min + max) / 2; }
};

/** Direction of the largest horizontal spread [rad]. */
double principalYaw(const std::vector<VoxelCoord>& voxels)
{
    const auto n = static_cast<double>(voxels.size());
    double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    for (const VoxelCoord& v : voxels) {
        mx += v.x / n;
        my += v.y / n;
    }
    for (const VoxelCoord& v : voxels) {
        const double dx = v.x - mx, dy = v.y - my;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
    // Rounding must not turn the box of a shape that has no direction.
    const double noise = 1e-9 * (xx + yy);
    const bool round = std::abs(xx - yy) <= noise && std::abs(xy) <= noise;
    return round ? 0 : 0.5 * std::atan2(2 * xy, xx - yy);
}
}  // namespace

OrientedBox orientedBox(const std::vector<VoxelCoord>& voxels, double resolution)
{
    OrientedBox box;
    box.yaw = principalYaw(voxels);
    const double c = std::cos(box.yaw), s = std::sin(box.yaw);
    Range along, across, height;
    for (const VoxelCoord& v : voxels) {
        const auto p = voxelCenter<mrpt::math::TPoint3D>(v, resolution);
        along.extend(c * p.x + s * p.y);
        across.extend(c * p.y - s * p.x);
        height.extend(p.z);
    }
    box.center = {c * along.middle() - s * across.middle(),
                  s * along.middle() + c * across.middle(), height.middle()};
    box.size = {along.max - along.min + resolution, across.max - across.min + resolution,
                height.max - height.min + resolution};
    return box;
}

std::map<instance_id_t, OrientedBox> orientedBoxes(const SemanticVoxelMap& map)
{
    std::map<instance_id_t, std::vector<VoxelCoord>> voxels;
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        if (evidence.winner() != UNKNOWN_INSTANCE) voxels[evidence.winner()].push_back(v);
    });
    std::map<instance_id_t, OrientedBox> boxes;
    for (const auto& [id, list] : voxels) boxes[id] = orientedBox(list, map.resolution());
    return boxes;
}
}  // namespace voxeland
