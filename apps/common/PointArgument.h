// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "common/Argument.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

namespace voxeland::apps
{
/** The finite numbers that commas separate in a text, blanks beside them allowed; none unless there
 * are just so many. */
std::vector<double> numbersIn(const std::string& text, size_t count);

/** Reads "x,y,z".
 *  \throws ConfigurationError unless the text is three finite numbers */
mrpt::math::TPoint3D parsePoint(const Text& option);

/** As parsePoint(), for a direction. \throws ConfigurationError for 0,0,0 too */
mrpt::math::TVector3D parseDirection(const Text& option);

/** Reads "low,high" [m].
 *  \throws ConfigurationError unless the text is two finite numbers, the first not the larger */
HeightRange parseHeights(const Text& option);
}  // namespace voxeland::apps
