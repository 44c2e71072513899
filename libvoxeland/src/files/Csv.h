// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace voxeland
{
/** A row of a table, without the blanks around its fields. */
struct CsvRow
{
    size_t line = 0;  //!< where it begins, from 1
    std::vector<std::string> fields;
};

/** All rows of a table in UTF-8; blank lines are left out. Fields are separated by what separates
 *  those of its first line: tabs, else semicolons, else commas; or by what that line says, "sep=;".
 *  A field in "..." may hold separators, ends of lines and doubled quotes.
 *  \param source name of the file, for messages
 *  \throws InputError, naming the line, if a quoted field does not end or is followed by more, or
 *  if the text is not UTF-8 */
std::vector<CsvRow> parseCsv(const std::string& text, const std::string& source);

/** The rows below a header.
 *  \param header names of the columns; the first row must name exactly these
 *  \throws InputError as above, and for another header or a row with another number of fields */
std::vector<CsvRow> parseCsv(const std::string& text, const std::vector<std::string>& header,
                             const std::string& source);

/** A text as a field of a table, in quotes where it needs them. */
std::string csvField(const std::string& text);
}  // namespace voxeland
