// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** What the name of an output stands for. Whoever writes a file asks here, so that links are
 * followed alike everywhere. */
struct OutputPlace
{
    /** The file that is made or replaced, absolute and without links; of what is written directly
     *  its name. */
    std::string path;
    /** Written as it is instead of replaced: a character device, or standard output where that is
     *  no file with a name. */
    bool isDirect = false;
};

/** Touches no file.
 *  \throws OutputError if no name is given, if its folder does not exist, or that of what a link
 *  points to, or if it is a folder, a pipe that nobody may read, a socket or a disk */
[[nodiscard]] OutputPlace outputPlaceOf(const std::string& name);
}  // namespace voxeland
