// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

namespace voxeland
{
/** A number of things as text: "1 room", "2 rooms".
 *  \param many plural of the word (default: the word and an s) */
inline std::string counted(uint64_t number, const std::string& one, const std::string& many = "")
{
    const std::string& word = number == 1 ? one : many.empty() ? one + "s" : many;
    return std::to_string(number) + " " + word;
}
}  // namespace voxeland
