// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/RefusedMemory.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <new>

/** MRPT's matrices go on with what this returns without looking at it, so that the program would
 *  crash. Another definition than the C library's, which is found first; it must not throw. */
extern "C" void* aligned_alloc(size_t alignment, size_t size) noexcept
{
    void* memory = nullptr;
    if (posix_memalign(&memory, std::max(alignment, sizeof(void*)), size) == 0) return memory;
    voxeland::RefusedMemory::note();
    std::terminate();
}

namespace voxeland
{
namespace
{
std::atomic<bool> refused{false};

int noteOpenCVError(int status, const char*, const char*, const char*, int, void*)
{
    if (status == cv::Error::StsNoMem) RefusedMemory::note();
    return 0;
}
}  // namespace

void RefusedMemory::watch()
{
    std::set_new_handler([] {
        note();
        throw std::bad_alloc();
    });
    cv::redirectError(noteOpenCVError);
}

void RefusedMemory::note() noexcept
{
    refused = true;
}

void RefusedMemory::noteErrno() noexcept
{
    if (errno == ENOMEM) note();
}

bool RefusedMemory::isNoted() noexcept
{
    return refused;
}

void RefusedMemory::forget() noexcept
{
    refused = false;
}

void RefusedMemory::check()
{
    if (refused) throw std::bad_alloc();
}
}  // namespace voxeland
