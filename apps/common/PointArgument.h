// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

#include <string>

namespace voxeland::apps
{
/** Reads "x,y,z".
 *  \param option name of the command line option, for the message
 *  \throws ConfigurationError unless the text is three finite numbers */
mrpt::math::TPoint3D parsePoint(const std::string& option, const std::string& text);
}  // namespace voxeland::apps
