// SPDX-License-Identifier: BSD-3-Clause
#include "ScanNetCategories.h"

#include "files/Csv.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <vector>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
constexpr const char* TABLE = "scannetv2-labels.combined.tsv";

fs::path findTable(const fs::path& sceneFolder)
{
    fs::path folder = fs::weakly_canonical(fs::absolute(sceneFolder));
    for (int level = 0; level < 3; ++level, folder = folder.parent_path())
        if (fs::exists(folder / TABLE)) return folder / TABLE;
    throw InputError("there is no " + std::string(TABLE) + " in " + sceneFolder.string() +
                     " or the two folders above: ScanNet provides it, put it there");
}

size_t columnOf(const std::vector<std::string>& header, const std::string& name,
                const std::string& file)
{
    const auto at = std::find(header.begin(), header.end(), name);
    if (at == header.end()) throw InputError(file + " has no column '" + name + "'");
    return static_cast<size_t>(at - header.begin());
}
}  // namespace

ScanNetCategories::ScanNetCategories(const fs::path& sceneFolder)
{
    const std::string file = findTable(sceneFolder).string();
    const auto rows = parseCsv(readTextFile(file), file);
    if (rows.empty()) throw InputError(file + " is empty");
    const auto& header = rows.front().fields;
    const size_t id = columnOf(header, "id", file), raw = columnOf(header, "raw_category", file),
                 nyu = columnOf(header, "nyu40class", file);
    for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
        const auto& cells = row->fields;
        const auto fail = [&](const std::string& problem) {
            throw InputError("line " + std::to_string(row->line) + " of " + file + problem);
        };
        if (cells.size() <= std::max({id, raw, nyu})) fail(" is cut off");
        const auto number = parsed<uint32_t>(cells[id]);
        if (!number) fail(" has the id '" + cells[id] + "', which is not a number");
        const std::string& category = cells[nyu].empty() ? cells[raw] : cells[nyu];
        m_ofRaw[cells[raw]] = category;
        m_ofNumber[*number] = category;
    }
}

std::string ScanNetCategories::ofRaw(const std::string& category) const
{
    const std::string name = trimmed(category);
    const auto at = m_ofRaw.find(name);
    return at == m_ofRaw.end() ? name : at->second;
}

std::string ScanNetCategories::ofNumber(uint32_t id) const
{
    const auto at = m_ofNumber.find(id);
    return at == m_ofNumber.end() ? "" : at->second;
}
}  // namespace voxeland
