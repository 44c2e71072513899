// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/InputFile.h"

#include "voxeland/base/errors.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace voxeland
{
uint64_t checkInputFile(const std::string& file, const std::string& purpose)
{
    const auto fail = [&](const std::string& why) {
        throw InputError("cannot read " + purpose + " " + file + ": " + why);
    };
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    switch (status.type()) {
        case fs::file_type::regular:
            break;
        case fs::file_type::not_found:
            fail("there is no such file");
            break;
        case fs::file_type::directory:
            fail("it is a folder: name a file");
            break;
        case fs::file_type::none:
            fail(error.message() + ": correct its path or its permissions");
            break;
        default:
            fail("it is a pipe or a device: write its content to a file first");
    }
    const uint64_t size = fs::file_size(file, error);
    return error ? 0 : size;
}
}  // namespace voxeland
