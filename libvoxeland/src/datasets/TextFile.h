// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Whole content of a file.
 *  \param purpose what the file is, for the message, e.g. "label map"
 *  \throws InputError, naming it, if it cannot be read */
std::string readTextFile(const std::string& file, const std::string& purpose = "file");
}  // namespace voxeland
