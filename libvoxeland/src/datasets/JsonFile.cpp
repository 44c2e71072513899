// SPDX-License-Identifier: BSD-3-Clause
#include "JsonFile.h"

#include "voxeland/errors.h"
#include "voxeland/files/TextFile.h"
#include "voxeland/trimmed.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

using nlohmann::json;

namespace voxeland
{
namespace
{
/** A text with null in place of the numbers that JSON lacks. */
std::string withoutOddNumbers(const std::string& text)
{
    constexpr std::string_view ODD[] = {"-Infinity", "Infinity", "NaN"};
    std::string result;
    bool quoted = false;
    for (size_t i = 0; i < text.size();) {
        const auto rest = std::string_view(text).substr(i);
        const auto* odd = std::find_if(std::begin(ODD), std::end(ODD), [&](const auto& word) {
            return !quoted && rest.compare(0, word.size(), word) == 0;
        });
        if (odd != std::end(ODD)) {
            result += "null";
            i += odd->size();
            continue;
        }
        if (text[i] == '"') quoted = !quoted;
        if (quoted && text[i] == '\\' && i + 1 < text.size()) result += text[i++];
        result += text[i++];
    }
    return result;
}

[[noreturn]] void fail(const std::string& text, size_t byte, const std::string& file)
{
    if (trimmed(text).empty()) throw InputError(file + " is empty: JSON is expected");
    const size_t at = std::min(text.size(), byte > 0 ? byte - 1 : 0);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = 1 + std::count(text.begin(), end, '\n');
    const auto newline = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
    const auto column = 1 + (end - newline.base());
    throw InputError(file + " is not valid JSON at line " + std::to_string(line) + ", column " +
                     std::to_string(column) +
                     (at == text.size() ? ", its end: it is cut off" : ""));
}

/** The objects of JSON Lines; nothing if a line is no object. */
std::optional<json> fromLines(const std::string& text)
{
    json list = json::array();
    std::istringstream lines(withoutOddNumbers(text));
    for (std::string line; std::getline(lines, line);) {
        if (trimmed(line).empty()) continue;
        json entry = json::parse(line, nullptr, false);
        if (!entry.is_object()) return std::nullopt;
        list.push_back(std::move(entry));
    }
    return list.size() > 1 ? std::optional(list) : std::nullopt;
}
}  // namespace

json parseJson(const std::string& text, const std::string& file)
{
    json value = json::parse(text, nullptr, false);
    if (!value.is_discarded()) return value;
    const std::string mended = withoutOddNumbers(text);
    try {
        return json::parse(mended);
    } catch (const json::parse_error& e) {
        fail(mended, e.byte, file);
    }
}

json readJson(const std::string& file)
{
    return parseJson(readTextFile(file), file);
}

json readJsonOrLines(const std::string& file)
{
    const std::string text = readTextFile(file);
    const auto lines = trimmed(text).substr(0, 1) == "{" ? fromLines(text) : std::nullopt;
    return lines ? *lines : parseJson(text, file);
}
}  // namespace voxeland
