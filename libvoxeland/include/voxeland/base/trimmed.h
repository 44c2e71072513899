// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>

namespace voxeland
{
/** A text without the blanks, also no-break spaces in UTF-8, and ends of lines around it. */
inline std::string trimmed(const std::string& text)
{
    constexpr const char* BLANKS = " \t\r\n";
    const std::string NO_BREAK = "\xC2\xA0";
    const size_t first = text.find_first_not_of(BLANKS);
    if (first == std::string::npos) return {};
    const std::string rest = text.substr(first, text.find_last_not_of(BLANKS) - first + 1);
    if (rest.compare(0, NO_BREAK.size(), NO_BREAK) == 0)
        return trimmed(rest.substr(NO_BREAK.size()));
    const size_t end = rest.size() - std::min(rest.size(), NO_BREAK.size());
    return rest.compare(end, std::string::npos, NO_BREAK) == 0 ? trimmed(rest.substr(0, end))
                                                               : rest;
}
}  // namespace voxeland
