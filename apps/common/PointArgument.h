// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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
 *  \param option name of the command line option, for the message
 *  \throws ConfigurationError unless the text is three finite numbers */
mrpt::math::TPoint3D parsePoint(const std::string& option, const std::string& text);

/** As parsePoint(), for a direction. \throws ConfigurationError for 0,0,0 too */
mrpt::math::TVector3D parseDirection(const std::string& option, const std::string& text);

/** Reads "low,high" [m].
 *  \param option name of the command line option, for the message
 *  \throws ConfigurationError unless the text is two finite numbers, the first not the larger */
HeightRange parseHeights(const std::string& option, const std::string& text);
}  // namespace voxeland::apps
