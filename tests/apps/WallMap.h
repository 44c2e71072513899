// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland::test
{
/** Writes a map of a wall 2.02 m in front of the origin, seen in five frames: its left half (y > 0)
 *  is a chair, its right half is unknown. */
void writeWallMap(const std::string& file);
}  // namespace voxeland::test
