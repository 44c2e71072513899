// SPDX-License-Identifier: BSD-3-Clause
#include "JsonFile.h"

#include "TextFile.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <iterator>

namespace voxeland
{
nlohmann::json parseJson(const std::string& text, const std::string& file)
{
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& e) {
        const size_t at = std::min(text.size(), e.byte > 0 ? e.byte - 1 : 0);
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
        const auto line = 1 + std::count(text.begin(), end, '\n');
        const auto newline = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
        const auto column = 1 + (end - newline.base());
        throw InputError(file + " is not valid JSON at line " + std::to_string(line) + ", column " +
                         std::to_string(column) +
                         (at == text.size() ? ", its end: it is cut off" : ""));
    }
}

nlohmann::json readJson(const std::string& file)
{
    return parseJson(readTextFile(file), file);
}
}  // namespace voxeland
