// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/OutputFolder.h"

#include "voxeland/base/errors.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace voxeland
{
void makeOutputFolder(const std::string& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!error && fs::is_directory(folder)) return;
    throw OutputError("cannot make the folder " + folder + ": " +
                      (error ? error.message() : "a file is in the way") +
                      ": choose another place");
}
}  // namespace voxeland
