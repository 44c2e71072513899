// SPDX-License-Identifier: BSD-3-Clause
#include "ScanNetCategories.h"

#include "TextFile.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
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

/** Cells of a line; blanks are part of them. */
std::vector<std::string> cellsOf(std::string line)
{
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == '\t')
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
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
    std::istringstream lines(readTextFile(file));
    std::string line;
    std::getline(lines, line);
    const auto header = cellsOf(line);
    const size_t id = columnOf(header, "id", file), raw = columnOf(header, "raw_category", file),
                 nyu = columnOf(header, "nyu40class", file);
    for (size_t number = 2; std::getline(lines, line); ++number) {
        if (line.empty() || line == "\r") continue;
        const auto cells = cellsOf(line);
        if (cells.size() <= std::max({id, raw, nyu}))
            throw InputError("line " + std::to_string(number) + " of " + file + " is cut off");
        const std::string& category = cells[nyu].empty() ? cells[raw] : cells[nyu];
        m_ofRaw[cells[raw]] = category;
        m_ofNumber[static_cast<uint32_t>(std::strtoul(cells[id].c_str(), nullptr, 10))] = category;
    }
}

std::string ScanNetCategories::ofRaw(const std::string& category) const
{
    const auto at = m_ofRaw.find(category);
    return at == m_ofRaw.end() ? category : at->second;
}

std::string ScanNetCategories::ofNumber(uint32_t id) const
{
    const auto at = m_ofNumber.find(id);
    return at == m_ofNumber.end() ? "" : at->second;
}
}  // namespace voxeland
