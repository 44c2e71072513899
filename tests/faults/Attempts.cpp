// SPDX-License-Identifier: BSD-3-Clause
#include "Attempts.h"

#include "common/CommandLine.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

namespace voxeland::test
{
namespace
{
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

Attempt attempt(Calls kind, unsigned n, int error, unsigned times,
                const std::function<void()>& work)
{
    int messages[2], calls[2];
    if (pipe(messages) != 0 || pipe(calls) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        failFrom(kind, n, error, times);
        workAndEnd(work, messages[1], calls[1]);
    }
    close(messages[1]);
    close(calls[1]);
    Attempt result;
    result.call = n;
    result.message = contentOf(messages[0]);
    const std::string seen = contentOf(calls[0]);
    if (!seen.empty()) result.calls = static_cast<unsigned>(std::stoul(seen));
    int status = 0;
    waitpid(child, &status, 0);
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
