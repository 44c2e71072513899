// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/files/InputFile.h"

#include "voxeland/base/errors.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <linux/magic.h>
#include <sys/vfs.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
/** Whether a file is one of those that the system makes up while they are read, as below /proc and
 *  /sys: they call themselves regular files, and yet may never end. */
bool isOfTheSystem(const std::string& file)
{
    constexpr unsigned long MADE_UP[] = {PROC_SUPER_MAGIC, SYSFS_MAGIC,        DEBUGFS_MAGIC,
                                         TRACEFS_MAGIC,    SECURITYFS_MAGIC,   SELINUX_MAGIC,
                                         SMACK_MAGIC,      CGROUP_SUPER_MAGIC, CGROUP2_SUPER_MAGIC,
                                         PSTOREFS_MAGIC,   EFIVARFS_MAGIC,     BPF_FS_MAGIC};
    struct statfs disk
    {
    };
    // The magic numbers have 32 bits, whatever type and sign f_type has here.
    return statfs(file.c_str(), &disk) == 0 &&
           std::find(std::begin(MADE_UP), std::end(MADE_UP), static_cast<uint32_t>(disk.f_type)) !=
               std::end(MADE_UP);
}
}  // namespace

uint64_t checkInputFile(const std::string& file, const std::string& purpose)
{
    const auto fail = [&](const std::string& why) {
        throw InputError("cannot read " + purpose + " " + file + ": " + why);
    };
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    switch (status.type()) {
        case fs::file_type::regular:
            if (isOfTheSystem(file))
                fail("it is made up by the system: write its content to a file first");
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
