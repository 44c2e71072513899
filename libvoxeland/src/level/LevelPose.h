// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/GravityAlignedFrame.h"

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/poses/CPose3D.h>

namespace voxeland
{
/** The pose, in the map's frame, of what has the axes of a gravity-aligned frame. */
inline mrpt::poses::CPose3D poseOf(const GravityAlignedFrame& frame,
                                   const mrpt::math::TPoint3D& origin)
{
    mrpt::math::CMatrixDouble33 rotation;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            rotation(row, column) = frame.axes()[static_cast<size_t>(column)][row];
    return mrpt::poses::CPose3D::FromRotationAndTranslation(
        rotation, mrpt::math::CVectorFixedDouble<3>({origin.x, origin.y, origin.z}));
}
}  // namespace voxeland
