// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/level/OrientedBox.h"

#include "grid/DensityClustering.h"
#include "voxeland/map/MapQueries.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

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
    [[nodiscard]] double length() const { return max - min; }
    [[nodiscard]] double middle() const { return (min + max) / 2; }
};

/** An object's voxels without what lies about: its connected parts (by faces, edges or corners) of
 *  at least a tenth of the largest one's voxels. */
std::vector<VoxelCoord> mainParts(const std::vector<VoxelCoord>& voxels)
{
    constexpr size_t SIZEABLE = 10;  // parts may be so many times smaller than the largest
    std::vector<WeightedCell> cells;
    for (const VoxelCoord& v : voxels) cells.push_back({v, 1, 1});
    const std::vector<int> parts = clusterByDensity(cells, 1);
    std::map<int, size_t> sizes;
    for (const int part : parts) ++sizes[part];
    const size_t largest = sizes[heaviestCluster(cells, parts)];
    std::vector<VoxelCoord> kept;
    for (size_t i = 0; i < voxels.size(); ++i)
        if (SIZEABLE * sizes[parts[i]] >= largest) kept.push_back(voxels[i]);
    return kept;
}

/** A direction in [-pi/4, pi/4): a rectangle looks the same every quarter of a turn. */
double withinAQuarter(double angle)
{
    constexpr double QUARTER = M_PI / 2;
    return angle - QUARTER * std::floor(angle / QUARTER + 0.5);
}

/** Extents of points along the axes turned by an angle. */
std::array<Range, 2> extentsOf(const std::vector<cv::Point2f>& points, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    std::array<Range, 2> sides;
    for (const cv::Point2f& p : points) {
        const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
        sides[0].extend(c * x + s * y);
        sides[1].extend(c * y - s * x);
    }
    return sides;
}

/** The direction of the longer side of the rectangle of least area around squares of edge 1 at
 * these points that stands along it [rad]. A side of that rectangle lies along one of their convex
 * hull (Freeman and Shapira, 1975; the edges added leave its area a product of concave functions of
 * the angle in between). Of rectangles that are hardly smaller the one turned least is taken. */
double yawOfLeastArea(const std::vector<cv::Point2f>& points)
{
    constexpr double HARDLY = 1e-4;  // share of the area
    std::vector<cv::Point2f> hull;
    cv::convexHull(points, hull);
    std::vector<double> angles = {0};
    for (size_t i = 0; i < hull.size(); ++i) {
        const cv::Point2f edge = hull[(i + 1) % hull.size()] - hull[i];
        angles.push_back(
            withinAQuarter(std::atan2(static_cast<double>(edge.y), static_cast<double>(edge.x))));
    }
    std::sort(angles.begin(), angles.end(),
              [](double a, double b) { return std::abs(a) < std::abs(b); });
    double best = 0, least = std::numeric_limits<double>::infinity();
    bool isTurned = false;
    for (const double angle : angles) {
        const auto sides = extentsOf(hull, angle);
        const double x = sides[0].length() + 1, y = sides[1].length() + 1;
        if (x * y >= least * (1 - HARDLY)) continue;
        least = x * y;
        best = angle;
        isTurned = y > x * (1 + HARDLY);
    }
    if (!isTurned) return best;
    return best > 0 ? best - M_PI / 2 : best + M_PI / 2;
}
}  // namespace

OrientedBox orientedBox(const std::vector<VoxelCoord>& voxels, double resolution,
                        const GravityAlignedFrame& frame)
{
    const std::vector<VoxelCoord> parts = mainParts(voxels);
    const TPoint3D first = frame.toLevel(voxelCenter<TPoint3D>(parts.front(), resolution));
    std::vector<cv::Point2f> plan;  // from there [edges]
    for (const VoxelCoord& v : parts) {
        const TPoint3D p =
            (frame.toLevel(voxelCenter<TPoint3D>(v, resolution)) - first) * (1 / resolution);
        plan.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    }
    OrientedBox box;
    box.yaw = yawOfLeastArea(plan);
    box.axes = frame.turned(box.yaw);
    std::array<Range, 3> sides;
    for (const VoxelCoord& v : parts) {
        const TPoint3D p = box.axes.toLevel(voxelCenter<TPoint3D>(v, resolution));
        for (size_t a = 0; a < 3; ++a) sides[a].extend(p[a]);
    }
    for (size_t a = 0; a < 3; ++a) box.size[a] = sides[a].length() + resolution;
    box.center = box.axes.toMap({sides[0].middle(), sides[1].middle(), sides[2].middle()});
    return box;
}

std::map<instance_id_t, OrientedBox> orientedBoxes(const SemanticVoxelMap& map,
                                                   const GravityAlignedFrame& frame)
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
