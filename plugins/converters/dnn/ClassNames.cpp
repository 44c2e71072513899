// SPDX-License-Identifier: BSD-3-Clause
#include "ClassNames.h"

#include "voxeland/base/errors.h"
#include "voxeland/datasets/CategoryNames.h"

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
    return inOrder(readCategoryNames(file), file);
}
}  // namespace voxeland
