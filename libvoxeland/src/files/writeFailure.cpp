// SPDX-License-Identifier: BSD-3-Clause
#include "writeFailure.h"

#include "voxeland/base/errors.h"

#include <cerrno>
#include <cstring>

namespace voxeland
{
namespace
{
/** What the user can do about it. */
const char* remedy(int error)
{
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or choose another place";
        case EFBIG:
            return "allow larger files (ulimit -f) or choose another disk";
        case EACCES:
        case EPERM:
        case EROFS:
            return "choose a place you may write to";
        default:
            return "check the path and the disk";
    }
}
}  // namespace

void failToWrite(const std::string& file, int error)
{
    throw OutputError("cannot write " + file + ": " +
                      (error == 0 ? "unknown reason" : std::strerror(error)) + ": " +
                      remedy(error));
}
}  // namespace voxeland
