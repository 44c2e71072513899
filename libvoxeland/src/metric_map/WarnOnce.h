// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Says on stderr what the user of an MRPT program must know. Each sentence once, not for each map:
 *  particle filters copy theirs all the time. */
void warnOnce(const std::string& sentence);
}  // namespace voxeland
