// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** Words one after another, with a separator between them. */
inline std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
    std::string text;
    for (size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : separator) + words[i];
    return text;
}
}  // namespace voxeland
