// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

#include <array>
#include <limits>

namespace voxeland
{
/** A map's frame turned about SemanticVoxelMap::origin() until z is up: there, heights are z and
 * floors are level. Its x axis is the map's as far as that is level; where up is +z it is the map's
 * frame. */
class GravityAlignedFrame
{
 public:
    /** The map's own frame: up is +z. */
    GravityAlignedFrame() = default;
    /** \param up in the map's frame, length > 0 */
    explicit GravityAlignedFrame(const mrpt::math::TVector3D& up);

    /** The frame's axes x, y, z in the map's frame: unit vectors. The last one is up. */
    [[nodiscard]] const std::array<mrpt::math::TVector3D, 3>& axes() const { return m_axes; }
    /** Another gravity-aligned frame, turned about up. \param yaw from this x axis to its [rad] */
    [[nodiscard]] GravityAlignedFrame turned(double yaw) const;
    [[nodiscard]] mrpt::math::TPoint3D toLevel(const mrpt::math::TPoint3D& inMap) const;
    [[nodiscard]] mrpt::math::TPoint3D toMap(const mrpt::math::TPoint3D& inLevel) const;

 private:
    std::array<mrpt::math::TVector3D, 3> m_axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/** Heights from `low` to `high` [m]; all by default. */
struct HeightRange
{
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool contains(double height) const { return height >= low && height <= high; }
};

/** Height of the floor in a gravity-aligned frame [m]: the top of the voxels above which 99 % of
 * the occupied ones lie, as some noise may be found below the floor. 0 in an empty map. Where no
 * floor was seen, it is the lowest that was. */
double floorHeight(const SemanticVoxelMap& map, const GravityAlignedFrame& frame);
}  // namespace voxeland
