// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland::test
{
/** Everything that a map file holds, uncompressed. */
std::string contentOfMap(const std::string& file);

/** Makes a map file that says in its configuration what its author likes, whatever made it.
 *  \param text shorter than what the map said before */
void forgeConfiguration(const std::string& file, const std::string& text);
}  // namespace voxeland::test
