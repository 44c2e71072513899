// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/datasets/CategoryNames.h"

#include "YamlNames.h"
#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/lowerCase.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/datasets/LabelMap.h"
#include "voxeland/files/Json.h"

#include <algorithm>
#include <cctype>
#include <optional>

using nlohmann::json;

namespace voxeland
{
namespace
{
/** {"id": number, "name": text}, or a name alone, which the place in the list numbers. */
void addEntry(CategoryNames& names, size_t place, const json& entry)
{
    if (entry.is_string())
        names[static_cast<int64_t>(place)] = entry.get<std::string>();
    else
        names[entry.at("id").get<int64_t>()] = entry.at("name").get<std::string>();
}

/** {"number": name} or {"name": number}. \return false if it is neither */
bool addPair(CategoryNames& names, const std::string& key, const json& value)
{
    const auto number = parsed<int64_t>(key);
    if (value.is_number_integer())
        names[value.get<int64_t>()] = key;
    else if (number && value.is_string())
        names[*number] = value.get<std::string>();
    else
        return false;
    return true;
}

CategoryNames fromJson(const json& root, const std::string& source)
{
    CategoryNames names;
    if (root.is_object()) {
        for (const char* key : {"categories", "names", "id2label"})
            if (root.contains(key)) return fromJson(root.at(key), source);
        for (const auto& [key, value] : root.items())
            if (!addPair(names, key, value))
                throw InputError(source + ": '" + key +
                                 "' is neither a category number with a name nor \"categories\"");
    } else {
        for (size_t i = 0; i < root.size(); ++i) addEntry(names, i, root.at(i));
    }
    return names;
}

/** Where a table has its numbers and its names. */
struct Columns
{
    size_t number = 0, name = 1;
    bool areNamesAlone = false;  //!< the header names no column of numbers, but one of names
};

/** What the first row says if it is a header. */
Columns columnsOf(const CsvRow& header)
{
    const auto at = [&](const std::vector<std::string>& titles) -> std::optional<size_t> {
        for (size_t i = 0; i < header.fields.size(); ++i) {
            const std::string title = lowerCase(header.fields[i]);
            if (std::find(titles.begin(), titles.end(), title) != titles.end()) return i;
        }
        return std::nullopt;
    };
    const auto number = at({"id", "index", "number", "category_id", "class_id", "label_id"});
    const auto name = at({"name", "category", "label", "class", "category_name", "class_name"});
    return {number.value_or(0), name.value_or(number == 1U ? 0 : 1), name && !number};
}

[[noreturn]] void failAt(const CsvRow& row, const std::string& source, const std::string& problem)
{
    throw InputError("line " + std::to_string(row.line) + " of " + source + " " + problem +
                     ": 'number,name' is expected");
}

/** "62 chair" and "62: chair" as two fields; nothing if it is anything else. */
std::optional<CsvRow> dividedAtNumber(const CsvRow& row)
{
    const std::string& text = row.fields.front();
    const size_t end = text.find_first_of(" \t:");
    if (end == std::string::npos || !parsed<int64_t>(text.substr(0, end))) return std::nullopt;
    return CsvRow{row.line, {text.substr(0, end), trimmed(text.substr(end + 1))}};
}

/** A name a row, numbered from 0. */
CategoryNames namesAlone(const std::vector<CsvRow>& rows, size_t column, const std::string& source)
{
    CategoryNames names;
    for (const CsvRow& row : rows) {
        const std::string name = row.fields.size() > column ? row.fields[column] : "";
        if (name.empty() || parsed<double>(name) ||
            name.find_first_of(":{}[]") != std::string::npos)
            failAt(row, source, "is no name of a category");
        names.emplace(static_cast<int64_t>(names.size()), name);
    }
    return names;
}

CategoryNames classesOf(const LabelMap& map)
{
    CategoryNames names;
    for (const auto& name : map.classes()) names.emplace(static_cast<int64_t>(names.size()), name);
    return names;
}

bool holdsNumber(const CsvRow& row)
{
    return std::any_of(row.fields.begin(), row.fields.end(),
                       [](const auto& f) { return parsed<int64_t>(f).has_value(); });
}

CategoryNames fromTable(std::vector<CsvRow> rows, const std::string& source)
{
    const Columns titles = columnsOf(rows.front());
    if (titles.areNamesAlone && std::none_of(rows.begin(), rows.end(), holdsNumber))
        return namesAlone({rows.begin() + 1, rows.end()}, titles.name, source);
    const auto isAlone = [](const CsvRow& row) { return row.fields.size() == 1; };
    if (std::all_of(rows.begin(), rows.end(), isAlone)) {
        if (!std::all_of(rows.begin(), rows.end(), dividedAtNumber))
            return namesAlone(rows, 0, source);
        for (CsvRow& row : rows) row = *dividedAtNumber(row);
    }
    CategoryNames names;
    auto row = rows.begin();
    const bool hasHeader = !holdsNumber(*row);
    const Columns columns = hasHeader ? titles : Columns();
    if (hasHeader) ++row;
    for (; row != rows.end(); ++row) {
        const auto& fields = row->fields;
        if (fields.size() <= std::max(columns.number, columns.name))
            failAt(*row, source, "has too few fields");
        const auto number = parsed<int64_t>(fields[columns.number]);
        const std::string& name = fields[columns.name];
        if (!number)
            failAt(*row, source,
                   "has '" + fields[columns.number] + "' where a category's number should be");
        if (name.empty()) failAt(*row, source, "has no name");
        const auto [known, isNew] = names.emplace(*number, name);
        if (!isNew && known->second != name)
            failAt(*row, source, "names category " + fields[columns.number] + " anew");
    }
    return names;
}
}  // namespace

CategoryNames categoryNamesFromTable(const std::string& text, const std::string& source)
{
    if (const auto names = namesFromYaml(text, source)) return *names;
    const auto rows = parseCsv(text, source);
    if (rows.empty()) return {};
    return LabelMap::isHeader(rows.front()) ? classesOf(LabelMap::fromText(text, source))
                                            : fromTable(rows, source);
}

CategoryNames readCategoryNames(const std::string& file)
{
    const std::string text = readTextFile(file, "category names");
    const size_t first = text.find_first_not_of(" \t\r\n");
    const bool isJson = first != std::string::npos && (text[first] == '{' || text[first] == '[');
    CategoryNames names;
    try {
        names = isJson ? fromJson(parseJson(text, file), file) : categoryNamesFromTable(text, file);
    } catch (const json::exception&) {
        throw InputError(file + ": every category needs a number \"id\" and a text \"name\"");
    }
    if (names.empty())
        throw InputError(file +
                         " names no categories: lines 'id,name' or COCO's JSON are expected");
    return names;
}
}  // namespace voxeland
