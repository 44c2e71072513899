// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** The names in a folder, in no order; none if it cannot be read. (The iterators of std::filesystem
 * end the program where there is no memory left.) */
std::vector<std::string> namesIn(const std::string& folder);
}  // namespace voxeland
