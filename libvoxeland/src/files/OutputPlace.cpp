// SPDX-License-Identifier: BSD-3-Clause
#include "OutputPlace.h"

#include "voxeland/base/errors.h"
#include "writeFailure.h"

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
using Status = struct stat;

bool isSame(const Status& a, const Status& b)
{
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/** Whether a name like /dev/stdout stands for what this program writes to. */
bool isStandardOutput(const Status& named)
{
    Status own{};
    return fstat(STDOUT_FILENO, &own) == 0 && isSame(named, own);
}

/** Where a file will be that is not there, or that a link points to in vain. */
std::string placeOfNew(const std::string& name)
{
    constexpr int MOST_LINKS = 40;  // as the system's; others may change them in the meantime
    std::error_code error;
    fs::path file = name;
    for (int i = 0; i < MOST_LINKS && fs::is_symlink(fs::symlink_status(file, error)); ++i)
        file = file.parent_path() / fs::read_symlink(file, error);
    const fs::path folder = file.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, error))
        throw OutputError("cannot write " + name + ": there is no folder " + folder.string() +
                          ": create it first");
    const fs::path real = fs::canonical(folder.empty() ? "." : folder, error);
    if (error) failToWrite(name, error.value());
    return (real / file.filename()).string();
}
}  // namespace

OutputPlace outputPlaceOf(const std::string& name)
{
    if (name.empty()) throw OutputError("no name given for an output file: give one");
    Status named{};
    if (stat(name.c_str(), &named) != 0) {
        if (errno != ENOENT && errno != ENOTDIR) failToWrite(name, errno);
        return {placeOfNew(name)};
    }
    if (S_ISDIR(named.st_mode))
        throw OutputError("cannot write " + name + ": it is a folder: name a file in it");
    std::error_code error;
    const fs::path real = fs::canonical(name, error);
    Status found{};
    // What is open, but has no name any more, the links of /proc/self/fd name wrongly.
    const bool hasName = !error && stat(real.c_str(), &found) == 0 && isSame(named, found);
    if (S_ISREG(named.st_mode) && hasName) return {real.string()};
    if (!S_ISCHR(named.st_mode) && !isStandardOutput(named))
        throw OutputError("cannot write " + name +
                          ": it is a pipe, socket or disk: name a file, or /dev/stdout");
    return {name, true};
}
}  // namespace voxeland
