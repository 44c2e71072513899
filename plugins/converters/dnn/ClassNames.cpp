// SPDX-License-Identifier: BSD-3-Clause
#include "ClassNames.h"

#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/datasets/LabelMap.h"
#include "voxeland/errors.h"

#include <algorithm>
#include <fstream>

namespace voxeland
{
namespace
{
std::vector<std::string> inOrder(const CategoryNames& names, const std::string& file)
{
    constexpr int64_t MOST = 100'000;
    const int64_t first = names.begin()->first;
    if (names.rbegin()->first - first >= MOST)
        throw InputError(file + " has numbers of classes that are too far apart");
    std::vector<std::string> list;
    for (const auto& [number, name] : names) {
        list.resize(static_cast<size_t>(number - first));
        list.push_back(name);
    }
    return list;
}

/** Lines that are not empty, without carriage returns. */
std::vector<std::string> linesOf(const std::string& file)
{
    std::ifstream in(file);
    if (!in) throw InputError("cannot open the class names '" + file + "'");
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (!line.empty()) lines.push_back(line);
    }
    return lines;
}
}  // namespace

std::vector<std::string> readClassNames(const std::string& file)
{
    const auto lines = linesOf(file);
    if (!lines.empty() && lines.front() == "name,class") return LabelMap::fromFile(file).classes();
    const bool areNamesAlone = std::none_of(lines.begin(), lines.end(), [](const auto& line) {
        return line.find_first_of(",[{") != std::string::npos;
    });
    if (areNamesAlone && !lines.empty()) return lines;
    return inOrder(readCategoryNames(file), file);
}
}  // namespace voxeland
