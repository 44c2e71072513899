// SPDX-License-Identifier: BSD-3-Clause
#include "FolderNames.h"

#include <dirent.h>
#include <memory>

namespace voxeland
{
std::vector<std::string> namesIn(const std::string& folder)
{
    std::vector<std::string> names;
    const std::shared_ptr<DIR> opened(opendir(folder.c_str()), [](DIR* d) {
        if (d != nullptr) closedir(d);
    });
    if (!opened) return names;
    while (const dirent* entry = readdir(opened.get())) names.emplace_back(entry->d_name);
    return names;
}
}  // namespace voxeland
