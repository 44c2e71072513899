// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Throws the OutputError for a file or folder that cannot be written: one sentence with its name,
 * the reason and what to do.
 *  \param error the system's errno; 0: not known */
[[noreturn]] void failToWrite(const std::string& file, int error);
}  // namespace voxeland
