// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** Of some words the one most like a misspelt one; empty if none is near. */
std::string nearestWord(const std::string& misspelt, const std::vector<std::string>& words);
}  // namespace voxeland
