// SPDX-License-Identifier: BSD-3-Clause
/** A library that stands before the C library, in a test program that links it or a program that
 * LD_PRELOAD gives it to, and lets calls fail. A program's faults are told by the environment:
 * VOXELAND_FAULT="KIND N ERRNO TIMES", the numbers as in failFrom(); they begin with main(). */
#include "Faults.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace voxeland::test
{
namespace
{
std::atomic<Calls> chosen{Calls::none};
std::atomic<unsigned> seen{0};
unsigned first = 0, last = 0;
int errorLeft = 0;

bool isChosen(Calls kind)
{
    const Calls wanted = chosen.load(std::memory_order_relaxed);
    return wanted == kind || (wanted == Calls::change &&
                              (kind == Calls::write || kind == Calls::sync || kind == Calls::name));
}

/** Whether this call is to fail: errno is set then. */
bool fails(Calls kind)
{
    if (!isChosen(kind)) return false;
    const unsigned n = ++seen;
    if (n < first || n > last) return false;
    if (errorLeft == KILL) kill(getpid(), SIGKILL);
    errno = errorLeft;
    return true;
}

/** What a program says is not what it writes. */
bool isFile(int descriptor)
{
    return descriptor > STDERR_FILENO;
}
bool isFile(FILE* stream)
{
    return stream != stdout && stream != stderr;
}

template <typename Function>
Function* next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
}  // namespace

void failFrom(Calls kind, unsigned n, int error, unsigned times)
{
    chosen = Calls::none;
    seen = 0;
    first = n;
    last = times == FOR_GOOD ? times : n + times - 1;
    errorLeft = error;
    chosen = kind;
}

unsigned callsSeen()
{
    return seen;
}
}  // namespace voxeland::test

using namespace voxeland::test;

#define CALL(kind, failure, result, name, parameters, arguments)  \
    extern "C" result name parameters                             \
    {                                                             \
        static auto* const real = next<result parameters>(#name); \
        return fails(Calls::kind) ? (failure) : real arguments;   \
    }

CALL(read, -1, ssize_t, read, (int f, void* data, size_t n), (f, data, n))
CALL(read, -1, ssize_t, pread64, (int f, void* data, size_t n, off64_t at), (f, data, n, at))
CALL(read, -1, ssize_t, readv, (int f, const iovec* data, int n), (f, data, n))
CALL(read, 0, size_t, fread, (void* data, size_t size, size_t n, FILE* f), (data, size, n, f))
CALL(write, -1, int, ftruncate64, (int f, off64_t size), (f, size))
CALL(write, -1, int, truncate64, (const char* file, off64_t size), (file, size))
CALL(write, -1, ssize_t, copy_file_range,
     (int from, off64_t* a, int to, off64_t* b, size_t n, unsigned flags),
     (from, a, to, b, n, flags))
CALL(write, -1, ssize_t, sendfile64, (int to, int from, off64_t* at, size_t n), (to, from, at, n))
CALL(sync, -1, int, fsync, (int f), (f))
CALL(sync, -1, int, fdatasync, (int f), (f))
CALL(sync, -1, int, syncfs, (int f), (f))
CALL(name, -1, int, rename, (const char* from, const char* to), (from, to))
CALL(name, -1, int, unlink, (const char* file), (file))
CALL(name, -1, int, unlinkat, (int folder, const char* file, int flags), (folder, file, flags))
CALL(name, -1, int, remove, (const char* file), (file))
CALL(name, -1, int, rmdir, (const char* folder), (folder))
CALL(name, -1, int, mkdir, (const char* folder, mode_t mode), (folder, mode))
CALL(name, -1, int, symlink, (const char* to, const char* file), (to, file))
CALL(open, nullptr, FILE*, fopen, (const char* file, const char* mode), (file, mode))
CALL(open, nullptr, FILE*, fopen64, (const char* file, const char* mode), (file, mode))

#define WRITE(failure, result, name, parameters, target, arguments)                \
    extern "C" result name parameters                                              \
    {                                                                              \
        static auto* const real = next<result parameters>(#name);                  \
        return isFile(target) && fails(Calls::write) ? (failure) : real arguments; \
    }

#define OPEN(name)                                                                 \
    extern "C" int name(const char* file, int flags, ...)                          \
    {                                                                              \
        static auto* const real = next<int(const char*, int, ...)>(#name);         \
        va_list more;                                                              \
        va_start(more, flags);                                                     \
        const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(more, unsigned) : 0; \
        va_end(more);                                                              \
        return fails(Calls::open) ? -1 : real(file, flags, mode);                  \
    }

WRITE(-1, ssize_t, write, (int f, const void* data, size_t n), f, (f, data, n))
WRITE(-1, ssize_t, pwrite64, (int f, const void* data, size_t n, off64_t at), f, (f, data, n, at))
WRITE(-1, ssize_t, writev, (int f, const iovec* data, int n), f, (f, data, n))
WRITE(0, size_t, fwrite, (const void* data, size_t size, size_t n, FILE* f), f, (data, size, n, f))

OPEN(open)
OPEN(open64)

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
extern "C" void* __libc_malloc(size_t);
extern "C" void* __libc_calloc(size_t, size_t);
extern "C" void* __libc_realloc(void*, size_t);
extern "C" void* __libc_memalign(size_t, size_t);

extern "C" void* malloc(size_t size)
{
    return fails(Calls::memory) ? nullptr : __libc_malloc(size);
}
extern "C" void* calloc(size_t n, size_t size)
{
    return fails(Calls::memory) ? nullptr : __libc_calloc(n, size);
}
extern "C" void* realloc(void* old, size_t size)
{
    return fails(Calls::memory) ? nullptr : __libc_realloc(old, size);
}
extern "C" int posix_memalign(void** result, size_t alignment, size_t size)
{
    *result = fails(Calls::memory) ? nullptr : __libc_memalign(alignment, size);
    return *result == nullptr ? ENOMEM : 0;
}
#endif

namespace
{
int (*programsMain)(int, char**, char**);

int mainWithFaults(int argc, char** argv, char** environment)
{
    if (const char* fault = std::getenv("VOXELAND_FAULT")) {
        int kind = 0, error = 0;
        unsigned n = 0, times = 0;
        if (std::sscanf(fault, "%d %u %d %u", &kind, &n, &error, &times) == 4)
            failFrom(static_cast<Calls>(kind), n, error, times);
    }
    return programsMain(argc, argv, environment);
}
}  // namespace

extern "C" int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv,
                                 void (*init)(), void (*fini)(), void (*rtldFini)(), void* stackEnd)
{
    programsMain = main;
    auto* const real = next<decltype(__libc_start_main)>("__libc_start_main");
    return real(mainWithFaults, argc, argv, init, fini, rtldFini, stackEnd);
}
