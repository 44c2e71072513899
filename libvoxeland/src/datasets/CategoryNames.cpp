// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/CategoryNames.h"

#include "JsonFile.h"
#include "TextFile.h"
#include "voxeland/errors.h"

#include <cstdlib>
#include <sstream>

namespace voxeland
{
namespace
{
CategoryNames fromJson(const nlohmann::json& json)
{
    CategoryNames names;
    const auto& list = json.is_object() ? json.at("categories") : json;
    for (size_t i = 0; i < list.size(); ++i) {
        const auto& entry = list.at(i);
        if (entry.is_string())
            names[static_cast<int64_t>(i)] = entry.get<std::string>();
        else
            names[entry.at("id").get<int64_t>()] = entry.at("name").get<std::string>();
    }
    return names;
}
}  // namespace

CategoryNames categoryNamesFromCsv(const std::string& text)
{
    CategoryNames names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        char* end = nullptr;
        const int64_t id = std::strtoll(line.c_str(), &end, 10);
        if (end != line.c_str() && *end == ',' && end[1] != '\0') names[id] = end + 1;
    }
    return names;
}

CategoryNames readCategoryNames(const std::string& file)
{
    const std::string text = readTextFile(file);
    const size_t first = text.find_first_not_of(" \t\r\n");
    const bool isJson = first != std::string::npos && (text[first] == '{' || text[first] == '[');
    CategoryNames names;
    try {
        names = isJson ? fromJson(parseJson(text, file)) : categoryNamesFromCsv(text);
    } catch (const nlohmann::json::exception&) {
        throw InputError(file + ": every category needs a number \"id\" and a text \"name\"");
    }
    if (names.empty())
        throw InputError(file +
                         " names no categories: lines 'id,name' or COCO's JSON are expected");
    return names;
}
}  // namespace voxeland
