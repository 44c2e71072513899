// SPDX-License-Identifier: BSD-3-Clause
/** What the sanitizers must know of this project, in each program that they are built into. */
#include <cstddef>
#include <new>

// Memory that cannot be had is refused as without sanitizers, by the handler of operator new or
// std::bad_alloc: readers of files count on it. Theirs end the program instead.
namespace
{
template <typename Allocate>
void* orRefuse(Allocate allocate)
{
    for (;;) {
        if (void* memory = allocate()) return memory;
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
