// SPDX-License-Identifier: BSD-3-Clause
#include "ClassNames.h"

#include "voxeland/datasets/CategoryNames.h"
#include "voxeland/datasets/LabelMap.h"
#include "voxeland/errors.h"
#include "voxeland/files/Csv.h"
#include "voxeland/files/TextFile.h"

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
}  // namespace

std::vector<std::string> readClassNames(const std::string& file)
{
    const std::string text = readTextFile(file, "class names");
    const std::vector<std::string> LABEL_MAP = {"name", "class"};
    const std::string firstLine = text.substr(0, text.find('\n'));
    const bool isJson = firstLine.find_first_of("[{") != std::string::npos;
    const auto rows = isJson ? std::vector<CsvRow>() : parseCsv(firstLine, file);
    if (!rows.empty() && rows.front().fields == LABEL_MAP)
        return LabelMap::fromFile(file).classes();
    return inOrder(readCategoryNames(file), file);
}
}  // namespace voxeland
