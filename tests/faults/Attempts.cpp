// SPDX-License-Identifier: BSD-3-Clause
#include "Attempts.h"

#include "common/CommandLine.h"

#include <iostream>
#include <sys/wait.h>
#include <unistd.h>

namespace voxeland::test
{
namespace
{
/** Ends the process as a program would that does this work; tells in the pipe whether a call
 * failed. */
[[noreturn]] void workAndEnd(unsigned n, const std::function<void()>& work, int messages, int hit)
{
    dup2(messages, STDERR_FILENO);
    const int exitCode = apps::runProgram("attempt", [&] {
        work();
        return 0;
    });
    const bool wasHit = callsSeen() >= n;
    failFrom(Calls::none, 1, 0);
    std::cerr << std::flush;
    if (write(hit, wasHit ? "y" : "n", 1) != 1) _exit(127);
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
    int messages[2], hit[2];
    if (pipe(messages) != 0 || pipe(hit) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        failFrom(kind, n, error, times);
        workAndEnd(n, work, messages[1], hit[1]);
    }
    close(messages[1]);
    close(hit[1]);
    Attempt result;
    result.message = contentOf(messages[0]);
    result.wasHit = contentOf(hit[0]) != "n";
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    return result;
}

unsigned attemptAll(Calls kind, int error, unsigned times, unsigned step,
                    const std::function<void()>& work,
                    const std::function<void(const Attempt&)>& afterwards)
{
    for (unsigned n = 1, attempts = 1;; n += step, ++attempts) {
        const Attempt result = attempt(kind, n, error, times, work);
        afterwards(result);
        if (!result.wasHit) return attempts;
    }
}
}  // namespace voxeland::test
