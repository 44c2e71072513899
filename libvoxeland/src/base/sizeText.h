// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** The size of an image as messages tell it: "640x480". */
template <typename Integer>
std::string sizeText(Integer columns, Integer rows)
{
    return std::to_string(columns) + "x" + std::to_string(rows);
}
}  // namespace voxeland
