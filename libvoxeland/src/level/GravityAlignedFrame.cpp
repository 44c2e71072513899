// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/level/GravityAlignedFrame.h"

#include <algorithm>
#include <cmath>

namespace voxeland
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

namespace
{
double dot(const TVector3D& a, const TVector3D& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

TVector3D cross(const TVector3D& a, const TVector3D& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
}  // namespace

GravityAlignedFrame::GravityAlignedFrame(const TVector3D& up)
{
    const TVector3D z = up * (1 / up.norm());
    const TVector3D ahead = std::abs(z.x) < 0.9 ? TVector3D(1, 0, 0) : TVector3D(0, 1, 0);
    const TVector3D level = ahead - z * dot(ahead, z);
    const TVector3D x = level * (1 / level.norm());
    m_axes = {x, cross(z, x), z};
}

GravityAlignedFrame GravityAlignedFrame::turned(double yaw) const
{
    const auto& [x, y, z] = m_axes;
    const double c = std::cos(yaw), s = std::sin(yaw);
    GravityAlignedFrame frame;
    frame.m_axes = {x * c + y * s, y * c - x * s, z};
    return frame;
}

TPoint3D GravityAlignedFrame::toLevel(const TPoint3D& inMap) const
{
    return {dot(m_axes[0], inMap), dot(m_axes[1], inMap), dot(m_axes[2], inMap)};
}

TPoint3D GravityAlignedFrame::toMap(const TPoint3D& inLevel) const
{
    return m_axes[0] * inLevel.x + m_axes[1] * inLevel.y + m_axes[2] * inLevel.z;
}

double floorHeight(const SemanticVoxelMap& map, const GravityAlignedFrame& frame)
{
    constexpr double BELOW_FLOOR = 0.01;
    std::vector<double> heights;
    heights.reserve(map.memory().surfaceVoxels);
    map.forEachVoxel([&](const VoxelCoord& v, const auto&...) {
        heights.push_back(frame.toLevel(voxelCenter<TPoint3D>(v, map.resolution())).z);
    });
    if (heights.empty()) return 0;
    const auto n = static_cast<long>(BELOW_FLOOR * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), heights.begin() + n, heights.end());
    return heights[static_cast<size_t>(n)] + map.resolution() / 2;
}
}  // namespace voxeland
