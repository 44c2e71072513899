// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/planning/DrivableFloor.h"

#include "grid/RayTraversal.h"
#include "level/HeightSlice.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TPose2D;

namespace voxeland
{
namespace
{
constexpr int DIRECTIONS = 32;

/** Whether a place lies in a box, or within a margin of it. \param inMap in the map's frame */
bool isInside(const OrientedBox& box, const TPoint3D& inMap, double margin)
{
    const TPoint3D p = box.axes.toLevel(inMap - box.center);
    return std::abs(p.x) <= box.size.x / 2 + margin && std::abs(p.y) <= box.size.y / 2 + margin &&
           std::abs(p.z) <= box.size.z / 2 + margin;
}

/** Distance from a box's middle to its border in a horizontal direction [m]. */
double distanceToBorder(const OrientedBox& box, double direction)
{
    const double angle = direction - box.yaw;
    return std::min(box.size.x / 2 / std::abs(std::cos(angle)),
                    box.size.y / 2 / std::abs(std::sin(angle)));
}
}  // namespace

DrivableFloor::DrivableFloor(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                             const DrivingRobot& robot)
    : m_map(map),
      m_frame(frame),
      m_robot(robot),
      m_floor(floorHeight(map, frame)),
      m_grid(std::make_shared<COccupancyGridMap2D>(
          gridOf(sliceOf(map, frame, {m_floor + robot.clearance, m_floor + robot.height}))))
{
}

bool DrivableFloor::fits(const TPoint2D& at) const
{
    const double edge = m_grid->getResolution();
    const double x = (at.x - m_grid->getXMin()) / edge, y = (at.y - m_grid->getYMin()) / edge;
    const double radius = m_robot.radius / edge;
    const auto columns = static_cast<double>(m_grid->getSizeX());
    const auto rows = static_cast<double>(m_grid->getSizeY());
    if (!(x >= 0 && x < columns && y >= 0 && y < rows)) return false;
    for (double row = std::floor(y - radius); row <= y + radius; ++row)
        for (double column = std::floor(x - radius); column <= x + radius; ++column) {
            // The cell is covered if that point of it is which is nearest to the robot's middle.
            const double dx = std::clamp(x, column, column + 1) - x;
            const double dy = std::clamp(y, row, row + 1) - y;
            const bool isFree =
                m_grid->getCell(static_cast<int>(column), static_cast<int>(row)) > 0.5F;
            if (!isFree && std::hypot(dx, dy) < radius) return false;
        }
    return true;
}

bool DrivableFloor::sees(const TPoint2D& from, const OrientedBox& box) const
{
    const TPoint3D eye = m_frame.toMap({from.x, from.y, m_floor + m_robot.eyes});
    bool hidden = false;
    traverseRay(eye, box.center, 1 / m_map.resolution(), [&](const VoxelCoord& v) {
        hidden = hidden ||
                 (OccupancyFilter::isOccupied(m_map.occupancy(v)) &&
                  !isInside(box, voxelCenter<TPoint3D>(v, m_map.resolution()), m_map.resolution()));
    });
    return !hidden;
}

std::vector<TPose2D> DrivableFloor::posesFacing(const OrientedBox& boxInWorld) const
{
    OrientedBox box = boxInWorld;
    box.center = m_map.inMap(box.center);
    const TPoint3D middle = m_frame.toLevel(box.center);
    std::vector<TPose2D> poses;
    for (int i = 0; i < DIRECTIONS; ++i) {
        const double direction = 2 * M_PI * i / DIRECTIONS;
        const double border = distanceToBorder(box, direction);
        for (double gap = m_robot.radius; gap <= m_robot.reach; gap += m_map.resolution()) {
            const TPoint2D at(middle.x + (border + gap) * std::cos(direction),
                              middle.y + (border + gap) * std::sin(direction));
            if (!fits(at) || !sees(at, box)) continue;
            poses.emplace_back(at.x, at.y, std::remainder(direction + M_PI, 2 * M_PI));
            break;
        }
    }
    const auto distance = [&](const TPose2D& p) {
        return std::hypot(p.x - middle.x, p.y - middle.y);
    };
    std::stable_sort(poses.begin(), poses.end(),
                     [&](const TPose2D& a, const TPose2D& b) { return distance(a) < distance(b); });
    return poses;
}
}  // namespace voxeland
