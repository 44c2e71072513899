// SPDX-License-Identifier: BSD-3-Clause
/** Memory that cannot be had is refused under the address sanitizer as without it, by the handler
 *  of operator new or std::bad_alloc: readers of files count on it. Its own operator new ends the
 *  program instead. */
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <sanitizer/allocator_interface.h>
#include <sys/resource.h>

namespace
{
constexpr std::size_t MOST = std::size_t{1} << 29;  // bytes of an object
std::atomic<std::size_t> limit{SIZE_MAX};           // bytes in all

/** Whether more would be beyond RLIMIT_AS. What destructors take after a refusal is granted. */
bool isExhausted()
{
    return limit != SIZE_MAX && std::uncaught_exceptions() == 0 &&
           __sanitizer_get_current_allocated_bytes() > limit;
}

template <typename Allocate>
void* orRefuse(Allocate allocate)
{
    for (;;) {
        void* memory = isExhausted() ? nullptr : allocate();
        if (memory != nullptr) return memory;
        const auto handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}
}  // namespace

/** RLIMIT_AS, by which readers limit what an object of a file takes, is that of operator new alone.
 *  The sanitizer has reserved its own address space, where what is small would not be counted, and
 *  it would end the program where it gets no more for itself. */
extern "C" int setrlimit(int resource, const rlimit* wanted) noexcept
{
    if (resource != RLIMIT_AS)
        return prlimit(0, static_cast<__rlimit_resource>(resource), wanted, nullptr);
    limit = wanted->rlim_cur == RLIM_INFINITY ? SIZE_MAX
                                              : __sanitizer_get_current_allocated_bytes() + MOST;
    return 0;
}

void* operator new(std::size_t bytes)
{
    return orRefuse([&] { return operator new(bytes, std::nothrow); });
}
void* operator new[](std::size_t bytes)
{
    return orRefuse([&] { return operator new[](bytes, std::nothrow); });
}
