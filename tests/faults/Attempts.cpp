// SPDX-License-Identifier: BSD-3-Clause
#include "Attempts.h"

#include "common/runProgram.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voxeland::test
{
namespace
{
constexpr int CANNOT_TRACE = 126;  // exit code

/** In a child: has its parent trace it from here on. */
void becomeTraced()
{
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(CANNOT_TRACE);
    raise(SIGSTOP);
}

/** Lets a child run, and kills it before its n-th system call. \return system calls it began */
unsigned killAt(unsigned n, pid_t child, int& status)
{
    waitpid(child, &status, 0);
    if (!WIFSTOPPED(status)) return 0;
    ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_EXITKILL | PTRACE_O_TRACESYSGOOD);
    unsigned calls = 0;
    int passed = 0;  // a signal that the child is to get
    for (bool isInside = false;;) {
        ptrace(PTRACE_SYSCALL, child, nullptr, passed);
        waitpid(child, &status, 0);
        if (!WIFSTOPPED(status)) return calls;
        const bool isCall = WSTOPSIG(status) == (SIGTRAP | 0x80);
        passed = isCall ? 0 : WSTOPSIG(status);
        if (isCall) isInside = !isInside;
        if (isCall && isInside && ++calls == n) kill(child, SIGKILL);
    }
}

/** Ends the process as a program would that does this work; tells in a pipe how many calls there
 * were. */
[[noreturn]] void workAndEnd(const std::function<void()>& work, int messages, int calls)
{
    dup2(messages, STDERR_FILENO);
    const int exitCode = apps::runProgram("attempt", [&] {
        work();
        return 0;
    });
    const std::string seen = std::to_string(callsSeen());
    failFrom(Calls::none, 1, 0);
    std::cerr << std::flush;
    if (write(calls, seen.data(), seen.size()) < 0) _exit(127);
    _exit(exitCode);
}

std::string contentOf(int pipe)
{
    std::string content;
    char bytes[4096];
    for (ssize_t n = 0; (n = read(pipe, bytes, sizeof(bytes))) > 0;)
        content.append(bytes, static_cast<size_t>(n));
    close(pipe);
    return content;
}
}  // namespace

bool canTrace()
{
    return attempt(Calls::system, ~0U, KILL, ONCE, [] {}).exitCode == 0;
}

Attempt attempt(Calls kind, unsigned n, int error, unsigned times,
                const std::function<void()>& work)
{
    int messages[2], calls[2];
    if (pipe(messages) != 0 || pipe(calls) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        if (kind == Calls::system)
            becomeTraced();
        else
            failFrom(kind, n, error, times);
        workAndEnd(work, messages[1], calls[1]);
    }
    close(messages[1]);
    close(calls[1]);
    Attempt result;
    int status = 0;
    const unsigned systemCalls = kind == Calls::system ? killAt(n, child, status) : 0;
    result.call = n;
    result.message = contentOf(messages[0]);
    const std::string seen = contentOf(calls[0]);
    if (kind == Calls::system) {
        result.calls = systemCalls;
    } else {
        if (!seen.empty()) result.calls = static_cast<unsigned>(std::stoul(seen));
        waitpid(child, &status, 0);
    }
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    return result;
}

unsigned attemptAll(Calls kind, int error, unsigned times, unsigned most,
                    const std::function<void()>& work,
                    const std::function<void(const Attempt&)>& afterwards)
{
    if (std::getenv("VOXELAND_ALL_FAULTS") != nullptr) most = std::numeric_limits<unsigned>::max();
    const Attempt whole = attempt(kind, std::numeric_limits<unsigned>::max(), 0, ONCE, work);
    afterwards(whole);
    unsigned attempts = 1;
    for (unsigned n = 1; n <= whole.calls; n += std::max(1U, whole.calls / most)) {
        afterwards(attempt(kind, n, error, times, work));
        ++attempts;
    }
    return attempts;
}
}  // namespace voxeland::test
