// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/WrittenFiles.h"

#include "voxeland/base/joined.h"

#include <algorithm>
#include <filesystem>

namespace voxeland
{
std::string WrittenFiles::told() const
{
    constexpr size_t NAMED = 3;
    if (m_names.empty()) return "; nothing was written";
    std::vector<std::string> named;
    for (size_t i = 0; i < std::min(NAMED, m_names.size()); ++i)
        named.push_back(std::filesystem::path(m_names[i]).filename().string());
    const size_t more = m_names.size() - named.size();
    return "; complete: " + joined(named, ", ") +
           (more > 0 ? " and " + std::to_string(more) + " more" : "");
}
}  // namespace voxeland
