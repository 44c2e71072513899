// SPDX-License-Identifier: BSD-3-Clause
/** What the sanitizers must know of this project, in each program that they are built into. */
#include <cstddef>
#include <new>

// Of those that replace the allocator.
extern "C" __attribute__((weak)) std::size_t __sanitizer_get_current_allocated_bytes();

// Memory that cannot be had is refused as without sanitizers, by the handler of operator new or
// std::bad_alloc: readers of files count on it. Theirs end the program instead.
namespace
{
/** Whether another allocation would be one too many. The address sanitizer reserves its address
 *  space when a program begins, so that RLIMIT_AS, by which readers limit what an object of a file
 *  takes, does not count what is allocated in small pieces. */
bool isExhausted()
{
    constexpr std::size_t MOST = std::size_t{1} << 29;  // bytes
    return __sanitizer_get_current_allocated_bytes != nullptr &&
           __sanitizer_get_current_allocated_bytes() > MOST;
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

void* operator new(std::size_t bytes)
{
    return orRefuse([&] { return operator new(bytes, std::nothrow); });
}
void* operator new[](std::size_t bytes)
{
    return orRefuse([&] { return operator new[](bytes, std::nothrow); });
}

extern "C" const char* __asan_default_options()
{
    return "allocator_may_return_null=1";
}

extern "C" const char* __lsan_default_suppressions()
{
    // MRPT loses the definition of a map whose settings are refused by an exception.
    return "leak:mrpt::maps::TSetOfMetricMapInitializers::loadFromConfigFile\n";
}

extern "C" const char* __ubsan_default_options()
{
    return "print_stacktrace=1";
}
