// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Whether an English noun in small letters is the plural of another: "boxes" of "box", "knives" of
 *  "knife", "people" of "person". Of several words the last one is in the plural: "potted plants".
 */
inline bool isPluralOf(const std::string& many, const std::string& one)
{
    const auto endsWith = [&](const std::string& end) {
        return one.size() >= end.size() &&
               one.compare(one.size() - end.size(), end.size(), end) == 0;
    };
    const auto becomes = [&](const std::string& ending, const std::string& plural) {
        return one.size() > ending.size() && endsWith(ending) &&
               many == one.substr(0, one.size() - ending.size()) + plural;
    };
    const auto turnsInto = [&](const std::string& word, const std::string& plural) {
        return (one == word && many == plural) || becomes(" " + word, " " + plural);
    };
    return becomes("", "s") || becomes("", "es") || becomes("y", "ies") || becomes("f", "ves") ||
           becomes("fe", "ves") || becomes("z", "zzes") || becomes("man", "men") ||
           turnsInto("person", "people") || turnsInto("mouse", "mice") ||
           turnsInto("child", "children") || turnsInto("foot", "feet") ||
           turnsInto("tooth", "teeth") || turnsInto("goose", "geese");
}
}  // namespace voxeland
