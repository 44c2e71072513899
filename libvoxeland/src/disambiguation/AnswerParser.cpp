// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/AnswerParser.h"

#include "voxeland/trimmed.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace voxeland
{
namespace
{
using Names = std::vector<std::pair<std::string, category_id_t>>;

/** Lower case, every run of other characters than letters, digits and bytes beyond ASCII one
 * space; '\n' and '.' stay if `sentences`. */
std::string words(const std::string& text, bool sentences)
{
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 0x80)
            result += static_cast<char>(std::tolower(byte));
        else if (sentences && (c == '\n' || c == '.'))
            result += '\n';
        else if (c == '\'')
            continue;  // "isn't" is one word
        else if (!result.empty() && result.back() != ' ')
            result += ' ';
    }
    return result;
}

/** What may be answered, long names first. */
Names answersFor(const std::vector<RankedCategory>& candidates)
{
    Names names;
    for (const RankedCategory& c : candidates)
        names.emplace_back(trimmed(words(c.name, false)), c.category);
    names.emplace_back(UNKNOWN_CATEGORY, UNKNOWN_CATEGORY_ID);
    std::stable_sort(names.begin(), names.end(),
                     [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
    return names;
}

/** Blanks all occurrences of some words. \return whether there were any */
bool take(std::string& text, const std::string& name)
{
    const std::string wanted = " " + name + " ";
    bool found = false;
    for (size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted)) {
        text.replace(at, wanted.size(), " | ");
        found = true;
    }
    return found;
}

std::optional<category_id_t> onlyOne(const std::set<category_id_t>& named)
{
    if (named.size() != 1) return std::nullopt;
    return *named.begin();
}

/** What the sentences of the form asked for name; an unknown name counts as several. */
std::optional<category_id_t> namedBySentences(const std::string& text, const Names& names,
                                              bool& anySentence)
{
    const std::string form = "the object category is ";
    std::set<category_id_t> named;
    for (size_t at = text.find(form); at != std::string::npos; at = text.find(form, at + 1)) {
        const size_t start = at + form.size();
        const std::string name = trimmed(text.substr(start, text.find('\n', start) - start));
        const auto known = std::find_if(names.begin(), names.end(),
                                        [&](const auto& n) { return n.first == name; });
        anySentence = true;
        if (known == names.end()) return std::nullopt;
        named.insert(known->second);
    }
    return onlyOne(named);
}

std::optional<category_id_t> namedAnywhere(const std::string& answer, const Names& names)
{
    std::string text = " " + words(answer, false) + " ";
    std::set<category_id_t> named;
    for (const auto& [name, category] : names)
        if (take(text, name)) named.insert(category);
    for (const char* negation : {"not", "no", "isnt", "neither", "nor", "cannot", "cant"})
        if (take(text, negation)) return std::nullopt;
    return onlyOne(named);
}
}  // namespace

std::optional<category_id_t> categoryNamedBy(const std::string& answer,
                                             const std::vector<RankedCategory>& candidates)
{
    const Names names = answersFor(candidates);
    bool anySentence = false;
    const auto named = namedBySentences(words(answer, true), names, anySentence);
    return anySentence ? named : namedAnywhere(answer, names);
}
}  // namespace voxeland
