// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace voxeland
{
/** Faces of voxels side by side in a plane, as one rectangle. */
struct FaceRectangle
{
    size_t side = 0;              //!< where it looks: in FACES
    std::array<int32_t, 3> low;   //!< x, y, z of the least of its voxels
    std::array<int32_t, 3> size;  //!< voxels along x, y, z; 1 along the axis it looks along
};

/** The faces of voxels that are not covered by another one of them, as few rectangles: rows of
 * faces as long as possible, and equal rows together. \param isCovered whether another one of them
 * is at a place */
std::vector<FaceRectangle> mergedFaces(const std::vector<VoxelCoord>& voxels,
                                       const std::function<bool(const VoxelCoord&)>& isCovered);
}  // namespace voxeland
