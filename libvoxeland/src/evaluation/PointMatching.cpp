// SPDX-License-Identifier: BSD-3-Clause
#include "PointMatching.h"

#include <cmath>

namespace voxeland
{
PointMatching::PointMatching(const SemanticVoxelMap& map, double radius)
    : m_map(map),
      m_radius(radius),
      m_reach(static_cast<int>(std::floor(radius / map.resolution() + 0.5)))
{
}

const VoxelEvidence* PointMatching::occupied(const VoxelCoord& v) const
{
    const MapBlock* block = m_map.blocks().find(blockOf(v));
    if (block == nullptr || !OccupancyFilter::isOccupied(block->occupancy(cellOf(v))))
        return nullptr;
    return block->evidence(cellOf(v));
}

const VoxelEvidence* PointMatching::find(const mrpt::math::TPoint3D& point) const
{
    const mrpt::math::TPoint3D p = m_map.inMap(point);
    const double reachable = (MAX_VOXEL_COORD - m_reach - 1) * m_map.resolution();
    if (!(std::abs(p.x) < reachable && std::abs(p.y) < reachable && std::abs(p.z) < reachable))
        return nullptr;
    const VoxelCoord center = m_map.voxelOf(p);
    if (const VoxelEvidence* inside = occupied(center)) return inside;

    const VoxelEvidence* nearest = nullptr;
    double best = m_radius * m_radius;
    for (int z = -m_reach; z <= m_reach; ++z)
        for (int y = -m_reach; y <= m_reach; ++y)
            for (int x = -m_reach; x <= m_reach; ++x) {
                const VoxelCoord v = center + VoxelCoord{x, y, z};
                const auto d = voxelCenter<mrpt::math::TPoint3D>(v, m_map.resolution()) - p;
                const double distance = d.sqrNorm();
                if (distance > best || (nearest != nullptr && distance == best)) continue;
                if (const VoxelEvidence* evidence = occupied(v)) {
                    nearest = evidence;
                    best = distance;
                }
            }
    return nearest;
}
}  // namespace voxeland
