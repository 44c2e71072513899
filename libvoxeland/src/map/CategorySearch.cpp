// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/CategorySearch.h"

#include "base/plural.h"
#include "voxeland/base/nearestWord.h"

#include <algorithm>
#include <cctype>

namespace voxeland
{
namespace
{
/** A name in small letters, its words one blank apart. */
std::string plain(const std::string& name)
{
    std::string result;
    bool isBetweenWords = false;
    for (const unsigned char c : name) {
        const bool isBlank = std::isspace(c) != 0 || c == '_' || c == '-';
        if (!isBlank && isBetweenWords && !result.empty()) result += ' ';
        if (!isBlank) result += static_cast<char>(std::tolower(c));
        isBetweenWords = isBlank;
    }
    return result;
}

bool isPluralEitherWay(const std::string& a, const std::string& b)
{
    return isPluralOf(a, b) || isPluralOf(b, a);
}

/** Whether a name contains a text, or words of it are the same in singular or plural. */
bool contains(const std::string& name, const std::string& text)
{
    if (name.find(text) != std::string::npos) return true;
    for (size_t first = 0; first != std::string::npos;) {
        for (size_t end = first; end != std::string::npos;) {
            end = name.find(' ', end + 1);
            const size_t length = end == std::string::npos ? end : end - first;
            if (isPluralEitherWay(text, name.substr(first, length))) return true;
        }
        const size_t blank = name.find(' ', first);
        first = blank == std::string::npos ? blank : blank + 1;
    }
    return false;
}
}  // namespace

NameFit nameFit(const std::string& wanted, const std::string& category)
{
    const std::string text = plain(wanted), name = plain(category);
    if (text.empty()) return NameFit::none;
    if (text == name) return NameFit::same;
    if (isPluralEitherWay(text, name)) return NameFit::plural;
    return contains(name, text) ? NameFit::part : NameFit::none;
}

std::string whyNoneIsFound(const SemanticVoxelMap& map, const std::string& wanted)
{
    const auto& known = map.categories().names();
    const auto fits = [&](const std::string& name) {
        return nameFit(wanted, name) >= NameFit::plural;
    };
    if (const auto at = std::find_if(known.begin(), known.end(), fits); at != known.end())
        return "no object of this map is most probably '" + *at +
               "', though it knows that category";
    const std::string nearest = nearestWord(wanted, known);
    return "no '" + wanted + "' in this map" +
           (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)");
}
}  // namespace voxeland
