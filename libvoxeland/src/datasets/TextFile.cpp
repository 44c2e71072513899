// SPDX-License-Identifier: BSD-3-Clause
#include "TextFile.h"

#include "voxeland/errors.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace voxeland
{
std::string readTextFile(const std::string& file, const std::string& purpose)
{
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw InputError("cannot read the " + purpose + " " + file);
    return {std::istreambuf_iterator<char>(in), {}};
}
}  // namespace voxeland
