// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland::test
{
/** Kinds of system calls and functions that can be made to fail. */
enum class Calls
{
    none,
    open,    //!< files opened or created
    read,    //!< from files
    write,   //!< to files
    sync,    //!< fsync, syncfs
    name,    //!< rename, unlink, mkdir, rmdir, symlink
    memory,  //!< malloc, calloc, realloc, aligned allocations
    change,  //!< all that changes files: write, sync, name
    system   //!< every system call: the process can only be killed there, by a tracer
};

constexpr int KILL = -1;  //!< instead of an errno: the process is killed before the call
constexpr unsigned ONCE = 1, FOR_GOOD = ~0U;  //!< how many calls fail

/** From now on, of this kind of call, counted from 1, the n-th and those behind it fail.
 *  \param error errno that the call leaves, or KILL
 *  \param times how many calls fail */
void failFrom(Calls kind, unsigned n, int error, unsigned times = ONCE);
/** Calls of that kind since failFrom(). */
unsigned callsSeen();
}  // namespace voxeland::test
