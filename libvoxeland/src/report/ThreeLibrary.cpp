// SPDX-License-Identifier: BSD-3-Clause
#include "ThreeLibrary.h"

#include "voxeland/base/errors.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace voxeland
{
namespace
{
std::string textOf(const std::string& file)
{
    std::ifstream in;
    if (std::filesystem::is_regular_file(file)) in.open(file, std::ios::binary);
    std::ostringstream text;
    if (!(text << in.rdbuf()))
        throw ConfigurationError("the report's 3D view needs '" + file +
                                 "': install the package libjs-three, or name the folder of "
                                 "three.js (version 109 to 147)");
    return text.str();
}
}  // namespace

ThreeLibrary ThreeLibrary::fromFolder(const std::string& folder)
{
    return {textOf(folder + "/three.min.js"),
            textOf(folder + "/examples/js/controls/OrbitControls.js")};
}
}  // namespace voxeland
