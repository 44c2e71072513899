// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland
{
/** Memory that the system refused to this program. That is thrown as std::bad_alloc, but streams,
 *  MRPT and OpenCV swallow it, and what was read then looks like a text that ends early or a
 *  damaged picture. Therefore it is noted, too, and whoever leaves something out or puts an output
 *  in its place asks first. Of the whole process, from any thread. */
class RefusedMemory
{
 public:
    /** Has it noted from now on when operator new or OpenCV get none: for programs, as it
     *  replaces std::set_new_handler() and cv::redirectError(). */
    static void watch();
    /** Of a program that watches; elsewhere nothing is noted, as nobody would look at it. */
    static void note() noexcept;
    /** The same, if that is what errno says after a function of a C library failed. */
    static void noteErrno() noexcept;
    [[nodiscard]] static bool isNoted() noexcept;
    /** For who expected it, and tells so: back to what isNoted() said before. */
    static void forget(bool wasNoted = false) noexcept;
    /** \throws std::bad_alloc if any was refused */
    static void check();
};
}  // namespace voxeland
