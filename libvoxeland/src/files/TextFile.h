// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** A text without the byte order mark that some editors put first; lines that end with CR alone end
 *  with LF, those with CR and LF stay. */
std::string plainText(std::string text);

/** Whole content of a file of UTF-8 text, as plainText().
 *  \param purpose what the file is, for the message, e.g. "label map"
 *  \throws InputError, naming it, if it cannot be read, is UTF-16 or a spreadsheet */
std::string readTextFile(const std::string& file, const std::string& purpose = "file");
}  // namespace voxeland
