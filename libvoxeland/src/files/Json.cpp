// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/Json.h"

#include "TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/files/InputFile.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

using nlohmann::json;

namespace voxeland
{
namespace
{
/** Calls f(place) for the characters outside of quotes. */
template <typename F>
void forEachUnquoted(const std::string& text, F&& f)
{
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"')
            quoted = !quoted;
        else if (quoted && text[i] == '\\')
            ++i;
        else if (!quoted)
            f(i);
    }
}

/** \throws InputError if a text is beyond JsonLimits */
void checkLimits(const std::string& text, const std::string& source)
{
    size_t depth = 0, deepest = 0, values = 0;
    forEachUnquoted(text, [&](size_t i) {
        const char c = text[i];
        if (c == '[' || c == '{')
            deepest = std::max(deepest, ++depth);
        else if ((c == ']' || c == '}') && depth > 0)
            --depth;
        if (c == '[' || c == '{' || c == ',' || c == ':') ++values;
    });
    if (deepest > JsonLimits::DEPTH)
        throw InputError(source + " nests lists and objects deeper than " +
                         std::to_string(JsonLimits::DEPTH) + " levels: it is damaged or no file " +
                         "that is meant here");
    if (values > JsonLimits::VALUES)
        throw InputError(source + " holds more than " +
                         std::to_string(JsonLimits::VALUES / 1000000) +
                         " million values: divide it");
}

/** A text with null in place of the numbers that JSON lacks. */
std::string withoutOddNumbers(const std::string& text)
{
    constexpr std::string_view ODD[] = {"-Infinity", "Infinity", "NaN"};
    std::string result;
    size_t copied = 0;
    forEachUnquoted(text, [&](size_t i) {
        if (i < copied) return;
        for (const auto& word : ODD) {
            if (text.compare(i, word.size(), word) != 0) continue;
            result.append(text, copied, i - copied).append("null");
            copied = i + word.size();
            return;
        }
    });
    return result.append(text, copied);
}

[[noreturn]] void fail(const std::string& text, size_t byte, const std::string& source)
{
    if (trimmed(text).empty()) throw InputError(source + " is empty: JSON is expected");
    const size_t at = std::min(text.size(), byte > 0 ? byte - 1 : 0);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = 1 + std::count(text.begin(), end, '\n');
    const auto newline = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
    const auto column = 1 + (end - newline.base());
    throw InputError(source + " is not valid JSON at line " + std::to_string(line) + ", column " +
                     std::to_string(column) +
                     (at == text.size() ? ", its end: it is cut off" : ": correct it there"));
}

/** The text between the first quotes. */
std::string quotedIn(const std::string& message)
{
    const size_t begin = message.find('\'') + 1;
    return message.substr(begin, message.rfind('\'') - begin);
}

/** The objects of JSON Lines, or the one of a line alone; nothing if a line is no object. */
std::optional<json> fromLines(const std::string& text)
{
    json list = json::array();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (trimmed(line).empty()) continue;
        auto entry = jsonFrom(line);
        if (!entry || !entry->is_object()) return std::nullopt;
        list.push_back(std::move(*entry));
    }
    return list.size() == 1 ? std::move(list.front()) : std::move(list);
}

std::string readJsonText(const std::string& file)
{
    if (checkInputFile(file, "the JSON file") > JsonLimits::BYTES)
        throw InputError(file + " is larger than " + std::to_string(JsonLimits::BYTES / 1000000) +
                         " MB: divide it");
    return readTextFile(file);
}
}  // namespace

json parseJson(const std::string& text, const std::string& source)
{
    checkLimits(text, source);
    json value = json::parse(text, nullptr, false);
    if (!value.is_discarded()) return value;
    const std::string mended = withoutOddNumbers(text);
    try {
        return json::parse(mended);
    } catch (const json::parse_error& e) {
        fail(mended, e.byte, source);
    } catch (const json::out_of_range& e) {
        throw InputError(source + " has the number " + printable(quotedIn(e.what()), 20) +
                         ", which is greater than any that can be computed with: correct it");
    }
}

std::optional<json> jsonFrom(const std::string& text)
{
    try {
        return parseJson(text, "");
    } catch (const InputError&) {
        return std::nullopt;
    }
}

json readJson(const std::string& file)
{
    return parseJson(readJsonText(file), file);
}

json readJsonOrLines(const std::string& file)
{
    const std::string text = readJsonText(file);
    checkLimits(text, file);
    auto lines = trimmed(text).substr(0, 1) == "{" ? fromLines(text) : std::nullopt;
    return lines ? std::move(*lines) : parseJson(text, file);
}
}  // namespace voxeland
