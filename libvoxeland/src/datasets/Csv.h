// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** Rows of a CSV text without its header; blank lines are left out, "..." may hold commas and
 *  doubled quotes.
 *  \param header names of the columns; the first line must name exactly these
 *  \param source name of the file, for messages
 *  \throws InputError for another header or a row with another number of fields */
std::vector<std::vector<std::string>> parseCsv(const std::string& text,
                                               const std::vector<std::string>& header,
                                               const std::string& source);
}  // namespace voxeland
