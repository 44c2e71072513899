// SPDX-License-Identifier: BSD-3-Clause
#include "CategoryNumbering.h"

#include "Tolerance.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace voxeland
{
namespace
{
/** COCO's categories that have annotations, by COCO's numbers. */
CategoryNames annotatedCocoNames()
{
    CategoryNames names = cocoCategoryNames();
    for (const int64_t unused : {12, 26, 29, 30, 45, 66, 68, 69, 71, 83, 91}) names.erase(unused);
    return names;
}

/** The same, numbered one after another. */
CategoryNames cocoNamesFrom(int64_t first)
{
    CategoryNames names;
    for (const auto& category : annotatedCocoNames()) names[first++] = category.second;
    return names;
}

std::string plain(std::string name)
{
    for (char& c : name)
        c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

bool agree(const CategoryNames& table, const CategoryNames& names)
{
    return std::all_of(names.begin(), names.end(), [&](const auto& category) {
        const auto at = table.find(category.first);
        return at == table.end() || plain(at->second) == plain(category.second);
    });
}

/** A way to number COCO's categories. */
struct Table
{
    CategoryNames names;
    std::string meaning;
};

/** \param eightyFirst which come first */
std::vector<Table> cocoTables(bool eightyFirst)
{
    std::vector<Table> tables = {{annotatedCocoNames(), "COCO's numbers 1 to 90"},
                                 {cocoNamesFrom(0), "COCO's 80 names counted from 0"},
                                 {cocoNamesFrom(1), "COCO's 80 names counted from 1"}};
    if (eightyFirst) std::rotate(tables.begin(), tables.begin() + 1, tables.end());
    return tables;
}

/** COCO's names of what is found in rooms: people, and its groups kitchen, furniture, electronic,
 *  appliance and indoor, by their places among the 80. */
std::set<std::string> namesOfRooms()
{
    std::set<std::string> names;
    for (const auto& [place, name] : cocoNamesFrom(0))
        if (place == 0 || (place >= 39 && place <= 45) || place >= 56) names.insert(name);
    return names;
}

/** Predictions that a table says are of things found in rooms, which is where depth is measured. */
size_t usesInRooms(const CategoryNames& table, const std::map<int64_t, size_t>& uses)
{
    static const std::set<std::string> rooms = namesOfRooms();
    size_t sum = 0;
    for (const auto& [number, count] : uses) {
        const auto named = table.find(number);
        if (named != table.end() && rooms.count(named->second) > 0) sum += count;
    }
    return sum;
}

/** The numbers that a table does not have. */
std::map<int64_t, size_t> usesOutside(const CategoryNames& names,
                                      const std::map<int64_t, size_t>& uses)
{
    std::map<int64_t, size_t> result;
    for (const auto& use : uses)
        if (names.count(use.first) == 0) result.insert(use);
    return result;
}

size_t total(const std::map<int64_t, size_t>& uses)
{
    size_t sum = 0;
    for (const auto& use : uses) sum += use.second;
    return sum;
}

std::string withoutName(const std::map<int64_t, size_t>& uses, const CategoryNumbers& numbers)
{
    return " (" + std::to_string(std::min(total(uses), numbers.predictions)) + " of " +
           counted(numbers.predictions, "prediction") + " without a name)";
}

const char* const REMEDY = "has no name: give the names with --categories";
}  // namespace

CategoryNumbering::CategoryNumbering(const CategoryNames& given, const CategoryNames& own,
                                     const CategoryNumbers& numbers)
    : m_names(given)
{
    m_names.insert(own.begin(), own.end());
    if (!given.empty()) {
        checkGiven(given, numbers);
        return;
    }
    if (!usesOutside(m_names, numbers.uses).empty()) addCocos(own, numbers);
    const auto nameless = usesOutside(m_names, numbers.uses);
    if (!isTolerable(total(nameless), numbers.predictions))
        throw InputError("category_id " + std::to_string(nameless.begin()->first) + " " + REMEDY +
                         withoutName(nameless, numbers));
}

void CategoryNumbering::checkGiven(const CategoryNames& given, const CategoryNumbers& numbers)
{
    const int64_t first = given.begin()->first, last = given.rbegin()->first;
    const std::string extent = counted(given.size(), "category", "categories") +
                               " given, which are numbered " + std::to_string(first) + " to " +
                               std::to_string(last);
    if (!numbers.uses.empty()) m_note = "category_ids are of the " + extent;
    const auto nameless = usesOutside(m_names, numbers.uses);
    const bool mayCountFromOne =
        first == 0 && numbers.uses.count(0) == 0 && nameless.count(last + 1) > 0;
    if (!mayCountFromOne && isTolerable(total(nameless), numbers.predictions)) return;
    const int64_t odd = mayCountFromOne ? last + 1 : nameless.begin()->first;
    throw InputError("category_id " + std::to_string(odd) + " is not among the " + extent +
                     (mayCountFromOne ? ": does category_id count from 1? Give lines 'number,name'"
                                      : withoutName(nameless, numbers)));
}

/** Those of the table that leaves the fewest predictions without a name, and of several such the
 * one by which most predictions are of things found in rooms. Where an odd number speaks for 80
 *  categories but nothing says from where they count, COCO's 90 are meant. */
void CategoryNumbering::addCocos(const CategoryNames& own, const CategoryNumbers& numbers)
{
    const auto nameless = usesOutside(m_names, numbers.uses);
    std::vector<Table> tables;
    for (Table& table : cocoTables(numbers.ofNamedImages))
        if (agree(table.names, own)) tables.push_back(std::move(table));
    if (tables.empty()) return;
    const auto unnamed = [&](const Table& t) { return total(usesOutside(t.names, nameless)); };
    const auto inRooms = [&](const Table& t) { return usesInRooms(t.names, nameless); };
    auto chosen =
        std::min_element(tables.begin(), tables.end(), [&](const Table& a, const Table& b) {
            return std::pair(unnamed(a), inRooms(b)) < std::pair(unnamed(b), inRooms(a));
        });
    const auto isAsGood = [&](const Table& t) {
        return &t != &*chosen && unnamed(t) <= unnamed(*chosen);
    };
    const bool isTied = std::any_of(tables.begin(), tables.end(), [&](const Table& t) {
        return isAsGood(t) && inRooms(t) == inRooms(*chosen);
    });
    const Table& ninety = tables.front();
    const bool areNinety =
        inRooms(ninety) == inRooms(*chosen) || unnamed(ninety) > unnamed(*chosen);
    if (isTied && !numbers.ofNamedImages && chosen != tables.begin() && areNinety) {
        chosen = tables.begin();
        if (!isTolerable(unnamed(*chosen), numbers.predictions))
            throw InputError(
                "category_id " +
                std::to_string(usesOutside(chosen->names, nameless).begin()->first) + " " + REMEDY +
                " (it is none of COCO's 90 categories; do the numbers count 80 from 0, or from "
                "1?)");
    }
    std::string others;
    for (const Table& table : tables)
        if (isAsGood(table)) others += (others.empty() ? "" : " or ") + table.meaning;
    m_names.insert(chosen->names.begin(), chosen->names.end());
    const std::string reading = "category_ids are read as " + chosen->meaning;
    const bool areUsual = chosen == tables.begin() && !isTied;
    if (others.empty() || areUsual)
        m_note = reading +
                 (numbers.ofNamedImages || !others.empty() ? ": --categories names others" : "");
    else
        m_doubt = reading + ", but may as well be " + others +
                  ": --categories with a file of lines 'number,name' tells";
}

const std::string& CategoryNumbering::nameOf(int64_t number) const
{
    const auto at = m_names.find(number);
    if (at == m_names.end())
        throw std::invalid_argument("category_id " + std::to_string(number) + " has no name");
    return at->second;
}
}  // namespace voxeland
