// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

namespace voxeland
{
/** Finds the voxel that stands for a point. Holds a reference to the map, which must not change
 *  meanwhile. */
class PointMatching
{
 public:
    /** \param radius reach of a voxel's centre [m] */
    PointMatching(const SemanticVoxelMap& map, double radius);

    /** Evidence of the occupied surface voxel that contains a point; where there is none, of the
     *  nearest one whose centre is within the radius (among equally near ones, the first by
     *  VoxelCoord's order); null if there is none either. \param p world frame [m] */
    [[nodiscard]] const VoxelEvidence* find(const mrpt::math::TPoint3D& p) const;

 private:
    [[nodiscard]] const VoxelEvidence* occupied(const VoxelCoord& v) const;

    const SemanticVoxelMap& m_map;
    double m_radius;
    int m_reach;  //!< how many voxels away a centre within the radius may be, on an axis
};
}  // namespace voxeland
