// SPDX-License-Identifier: BSD-3-Clause
#include "CategoryNumbering.h"

#include "voxeland/counted.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <cctype>
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

struct Table
{
    CategoryNames names;
    std::string note;
};

std::vector<Table> cocoTables()
{
    return {{annotatedCocoNames(), "category_id is COCO's number of a category, 1 to 90"},
            {cocoNamesFrom(0), "category_id counts COCO's 80 categories from 0"},
            {cocoNamesFrom(1), "category_id counts COCO's 80 categories from 1"}};
}
}  // namespace

CategoryNumbering::CategoryNumbering(const CategoryNames& given, const CategoryNames& own,
                                     const std::set<int64_t>& numbers)
    : m_names(given)
{
    m_names.insert(own.begin(), own.end());
    std::set<int64_t> nameless;
    for (const int64_t n : numbers)
        if (m_names.count(n) == 0) nameless.insert(n);
    if (nameless.empty()) return;

    if (!given.empty())
        throw InputError("category_id " + std::to_string(*nameless.begin()) + " is not among the " +
                         counted(given.size(), "category", "categories") +
                         " given, which are numbered " + std::to_string(given.begin()->first) +
                         " to " + std::to_string(given.rbegin()->first));
    const auto tables = cocoTables();
    std::vector<const Table*> fitting;
    for (const Table& table : tables)
        if (agree(table.names, own) &&
            std::all_of(nameless.begin(), nameless.end(),
                        [&](int64_t n) { return table.names.count(n) > 0; }))
            fitting.push_back(&table);
    if (fitting.empty() || (fitting.size() > 1 && fitting.front() != &tables.front())) {
        const auto& coco = tables.front().names;
        const auto odd = std::find_if(nameless.begin(), nameless.end(),
                                      [&](int64_t n) { return coco.count(n) == 0; });
        const int64_t first = odd == nameless.end() ? *nameless.begin() : *odd;
        throw InputError("category_id " + std::to_string(first) +
                         " has no name: give the names with --categories" +
                         (fitting.empty() ? ""
                                          : " (it is none of COCO's 90 categories; do the numbers "
                                            "count 80 from 0, or from 1?)"));
    }
    m_names.insert(fitting.front()->names.begin(), fitting.front()->names.end());
    m_note = fitting.front()->note;
}
}  // namespace voxeland
