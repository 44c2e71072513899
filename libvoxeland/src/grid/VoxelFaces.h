// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <array>

namespace voxeland
{
/** The faces of a cube, as the way to the voxel beyond: -x, +x, -y, +y, -z, +z. */
inline constexpr std::array<VoxelCoord, 6> FACES = {
    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
}  // namespace voxeland
