// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace voxeland
{
/** Of printable(): show all of it. */
constexpr size_t UNCUT = std::string_view::npos;

/** Text from anywhere (names in files, answers, errors of servers, paths) as a terminal and a
 * person can take it, on one line and in valid UTF-8: what controls a terminal, breaks a line,
 * turns the direction of writing or is no UTF-8 is shown as `\n`, `\t`, `\x1b` (bytes) or `\u202e`
 *  (characters), what hideText() names as that says. Only for showing: files keep names as they
 *  are.
 *  \param maxLength of a longer text begin and end are shown with "..." between them, these many
 *  characters in all (at least 8) */
std::string printable(std::string_view text, size_t maxLength = 80);

/** Whether printable() would show a text as it is, were it not too long or hidden. */
bool isPrintable(std::string_view text);

/** printable() for a whole sentence: if it is too long, its longest words (paths, names) are
 *  shortened first, so that what is wrong and what to do stay readable. */
std::string printableSentence(std::string_view text, size_t maxLength = 300);
}  // namespace voxeland
