// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/RefusedMemory.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <new>

namespace
{
std::atomic<bool> watched{false}, refused{false};
}  // namespace

/** MRPT's matrices go on with what this returns without looking at it, so that a program would
 *  crash: one that watches ends instead, by its terminate handler. Another definition than the C
 *  library's, which is found first; it must not throw. */
extern "C" void* aligned_alloc(size_t alignment, size_t size) noexcept
{
    void* memory = nullptr;
    const int error = posix_memalign(&memory, std::max(alignment, sizeof(void*)), size);
    if (error == 0) return memory;
    errno = error;
    if (watched && error == ENOMEM) {
        voxeland::RefusedMemory::note();
        std::terminate();
    }
    return nullptr;
}

namespace voxeland
{
namespace
{

int noteOpenCVError(int status, const char*, const char*, const char*, int, void*)
{
    if (status == cv::Error::StsNoMem) RefusedMemory::note();
    return 0;
}
}  // namespace

void RefusedMemory::watch()
{
    watched = true;
    std::set_new_handler([] {
        note();
        throw std::bad_alloc();
    });
    cv::redirectError(noteOpenCVError);
}

void RefusedMemory::note() noexcept
{
    if (watched) refused = true;
}

void RefusedMemory::noteErrno() noexcept
{
    if (errno == ENOMEM) note();
}

bool RefusedMemory::isNoted() noexcept
{
    return refused;
}

void RefusedMemory::forget(bool wasNoted) noexcept
{
    refused = wasNoted;
}

void RefusedMemory::check()
{
    if (refused) throw std::bad_alloc();
}
}  // namespace voxeland
