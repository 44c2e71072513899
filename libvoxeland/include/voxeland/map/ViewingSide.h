// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

#include <cstdint>

namespace voxeland
{
/** From the camera to what it looks at, of length 1; along z if they are one point. */
mrpt::math::TPoint3Df viewingDirection(const mrpt::math::TPoint3Df& camera,
                                       const mrpt::math::TPoint3Df& target);

/** Number of the sector a direction lies in, some 25 degrees wide: each coordinate in steps of one
 * half. \param direction of length 1 \return in [0,125) */
uint16_t sectorOf(const mrpt::math::TPoint3Df& direction);

/** Number of a side of an object: a sector of viewing directions and an octave of distances. */
using side_t = uint16_t;
/** There are no more sides than this. */
inline constexpr side_t SIDES = 125 * 16;

/** The side from which a camera looks at a place: directions in one sectorOf() and distances from
 * 2^n to 2^(n+1) m, n in [-8,7]. Both places are in one frame [m]. \return in [0,SIDES) */
side_t sideOf(const mrpt::math::TPoint3Df& camera, const mrpt::math::TPoint3Df& target);
}  // namespace voxeland
