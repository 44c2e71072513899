// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/OrientedBox.h"

#include "voxeland/map/MapQueries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voxeland
{
using mrpt::math::TPoint3D;

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

/** Direction of the largest horizontal spread [rad]. \param points in a level frame */
double principalYaw(const std::vector<TPoint3D>& points)
{
    const auto n = static_cast<double>(points.size());
    double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    for (const TPoint3D& p : points) {
        mx += p.x / n;
        my += p.y / n;
    }
    for (const TPoint3D& p : points) {
        const double dx = p.x - mx, dy = p.y - my;
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

OrientedBox orientedBox(const std::vector<VoxelCoord>& voxels, double resolution,
                        const LevelFrame& frame)
{
    std::vector<TPoint3D> points;
    for (const VoxelCoord& v : voxels)
        points.push_back(frame.toLevel(voxelCenter<TPoint3D>(v, resolution)));
    OrientedBox box;
    box.yaw = principalYaw(points);
    box.axes = frame.turned(box.yaw);
    std::array<Range, 3> sides;
    for (const VoxelCoord& v : voxels) {
        const TPoint3D p = box.axes.toLevel(voxelCenter<TPoint3D>(v, resolution));
        for (size_t a = 0; a < 3; ++a) sides[a].extend(p[a]);
    }
    for (size_t a = 0; a < 3; ++a) box.size[a] = sides[a].max - sides[a].min + resolution;
    box.center = box.axes.toMap({sides[0].middle(), sides[1].middle(), sides[2].middle()});
    return box;
}

std::map<instance_id_t, OrientedBox> orientedBoxes(const SemanticVoxelMap& map,
                                                   const LevelFrame& frame)
{
    std::map<instance_id_t, OrientedBox> boxes;
    for (const auto& [id, voxels] : voxelsByWinner(map))
        if (id != UNKNOWN_INSTANCE) {
            OrientedBox& box = boxes[id] = orientedBox(voxels, map.resolution(), frame);
            box.center = map.inWorld(box.center);
        }
    return boxes;
}
}  // namespace voxeland
