// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Makes a folder, and those above it, unless it exists.
 *  \throws OutputError if that is not possible */
void makeOutputFolder(const std::string& folder);
}  // namespace voxeland
