// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/RefusedMemory.h"

#include <mrpt/core/aligned_allocator.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>

namespace
{
std::atomic<bool> watched{false}, refused{false};
}  // namespace

/** MRPT's own returns null, and its matrices go on with that. Another definition than theirs, which
 *  is found first. */
void* mrpt::aligned_malloc(size_t size, size_t alignment)
{
    void* memory = nullptr;
    if (posix_memalign(&memory, std::max(alignment, sizeof(void*)), size) == 0) return memory;
    voxeland::RefusedMemory::note();
    throw std::bad_alloc();
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
