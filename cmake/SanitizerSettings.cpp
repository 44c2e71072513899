// SPDX-License-Identifier: BSD-3-Clause
/** What the sanitizers must know of this project, in each program that they are built into. */
#include <cstddef>
#include <new>

// Memory that cannot be had is refused, as without sanitizers, by std::bad_alloc: a reader of files
// counts on it. Theirs end the program instead.
namespace
{
void* orThrow(void* memory)
{
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
}  // namespace

void* operator new(std::size_t bytes)
{
    return orThrow(operator new(bytes, std::nothrow));
}
void* operator new[](std::size_t bytes)
{
    return orThrow(operator new[](bytes, std::nothrow));
}

extern "C" const char* __asan_default_options()
{
    return "allocator_may_return_null=1";
}

extern "C" const char* __ubsan_default_options()
{
    return "print_stacktrace=1";
}
