// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>

#include <string>

namespace voxeland
{
/** A time as messages tell it: "2026/11/27,13:50:00.000000" (UTC). From any thread, which MRPT's
 *  own function may not be called from. */
std::string timeText(const mrpt::Clock::time_point& time);
}  // namespace voxeland
