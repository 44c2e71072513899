// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/BlockMap.h"
#include "voxeland/grid/CellMask.h"
#include "voxeland/observations/VoxelizedFrame.h"

namespace voxeland
{
/** What one frame saw of a block's cells. */
struct ObservedBlock
{
    CellMask hit;     //!< a point was measured in the cell
    CellMask passed;  //!< a ray went through the cell on its way to what it met; none of `hit`
    CellMask behind;  //!< right behind a measured surface, within the visibility margin

    /** Cells that the camera can see, the margin included. */
    [[nodiscard]] CellMask visible() const { return hit | passed | behind; }
};

/** The part of space one frame saw. */
using ObservedSpace = BlockMap<ObservedBlock>;

/** What the rays of one frame may go through: more would take minutes, or gigabytes. */
struct RayLimits
{
    static constexpr uint64_t CELLS = 500000000;  //!< those of all rays together
    static constexpr size_t BLOCKS = 1000000;     //!< of 8x8x8 cells
};

/** Casts one exact ray from the optical centre to the mean point of every hit voxel, and on by
 *  `visibilityMargin` behind it; and one to every voxel of VoxelizedFrame::beyond(), that voxel not
 *  included.
 *  \param visibilityMargin depth noise within which a voxel counts as seen [m]
 *  \throws UnusableFrame if it is beyond RayLimits, or farther off than a map can hold */
ObservedSpace castRays(const VoxelizedFrame& frame, double visibilityMargin);
}  // namespace voxeland
