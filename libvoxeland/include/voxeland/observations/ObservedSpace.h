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

/** Casts one exact ray from the optical centre to the mean point of every hit voxel, and on by
 *  `visibilityMargin` behind it; and one to every voxel of VoxelizedFrame::beyond(), that voxel not
 *  included.
 *  \param visibilityMargin depth noise within which a voxel counts as seen [m] */
ObservedSpace castRays(const VoxelizedFrame& frame, double visibilityMargin);
}  // namespace voxeland
