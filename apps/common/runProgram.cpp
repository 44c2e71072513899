// SPDX-License-Identifier: BSD-3-Clause
#include "common/runProgram.h"

#include "common/Interruption.h"
#include "common/Signals.h"
#include "common/say.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/hiddenTexts.h"

#include <mrpt/core/exceptions.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <unistd.h>

namespace fs = std::filesystem;

namespace voxeland::apps
{
namespace
{
int fail(const std::string& program, const std::string& text, int exitCode)
{
    constexpr size_t LONGEST = 299;
    say(program + ": " + text, LONGEST);
    return exitCode;
}

constexpr auto OUT_OF_MEMORY = "out of memory: use a coarser resolution or a smaller input";
constexpr int UNREADABLE = 3;  // exit code

/** In a function that must not throw, in our code or another library's, the lack of memory ends the
 * program. Says so, without memory. */
[[noreturn]] void endWithoutMemory()
{
    if (!RefusedMemory::isNoted()) std::abort();
    const char* const PARTS[] = {program_invocation_short_name, ": ", OUT_OF_MEMORY, "\n"};
    for (const char* text : PARTS)
        static_cast<void>(!write(STDERR_FILENO, text, std::strlen(text)));
    _exit(UNREADABLE);
}

/** Takes the numbers of standard streams that are closed: the next file that was opened would get
 * them, and what is printed would go there. */
void holdStandardStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/", O_PATH | O_CLOEXEC));
}

/** \throws OutputError if nothing can be printed */
void checkStandardOutput()
{
    if ((fcntl(STDOUT_FILENO, F_GETFL) & O_ACCMODE) == O_RDONLY)
        throw OutputError("cannot write to standard output: it is closed: redirect it to a file");
}

int runWatched(const char* program, const std::function<int()>& body)
{
    try {
        checkStandardOutput();
        const int exitCode = body();
        RefusedMemory::check();
        if (!std::cout.flush())
            throw OutputError("cannot write to standard output: free some space");
        return exitCode;
    } catch (const Interrupted& e) {
        fail(program, e.what(), INTERRUPTED);
        if (!e.command.empty()) std::cerr << withoutHidden(e.command) << "\n";
        return INTERRUPTED;
    } catch (...) {
        // Whatever the lack of memory was taken for.
        RefusedMemory::check();
        throw;
    }
}

/** A message without the place in MRPT's sources that begins its own: "file.cpp:57: [function] ".
 */
std::string withoutPlace(const std::string& text)
{
    const size_t function = text.find(": ["), end = text.find("] ");
    if (function == std::string::npos || end == std::string::npos || end < function) return text;
    const fs::path place = text.substr(0, text.rfind(':', function - 1));
    const bool isSource = place.extension() == ".cpp" || place.extension() == ".h";
    return isSource && place.string().find(' ') == std::string::npos ? text.substr(end + 2) : text;
}

/** Whether a message is one of a library for programmers: nobody has said what it means. */
bool isJargon(const std::exception& e, const std::string& message)
{
    const auto begins = [&](const std::string& start) {
        return message.compare(0, start.size(), start) == 0;
    };
    return begins("OpenCV(") || begins("[json.exception") ||
           message.find(' ') == std::string::npos ||
           dynamic_cast<const std::length_error*>(&e) != nullptr ||
           dynamic_cast<const std::out_of_range*>(&e) != nullptr;
}
}  // namespace

std::string sentence(const std::exception& e)
{
    if (const auto* files = dynamic_cast<const fs::filesystem_error*>(&e))
        return "cannot use '" + files->path1().string() + "': " + files->code().message() +
               ": correct the path or its permissions";
    const auto* mrpts = dynamic_cast<const mrpt::ExceptionWithCallBackBase*>(&e);
    const std::string text = mrpts != nullptr ? mrpts->originalWhat : e.what();
    const std::string line = withoutPlace(text.substr(0, text.find('\n')));
    return isJargon(e, line) ? "an input is damaged or not of the kind that is expected (" + line +
                                   "): leave out one after the other to find it"
                             : line;
}

int runProgram(const char* program, const std::function<int()>& body)
{
    holdStandardStreams();
    setUpSignals();
    RefusedMemory::watch();
    std::set_terminate(&endWithoutMemory);
    try {
        return runWatched(program, body);
    } catch (const ConfigurationError& e) {
        return fail(program, sentence(e), 1);
    } catch (const PluginError& e) {
        return fail(program, sentence(e), 2);
    } catch (const NothingToMapError& e) {
        return fail(program, sentence(e), 4);
    } catch (const OutputError& e) {
        return fail(program, sentence(e), 5);
    } catch (const std::bad_alloc&) {
        return fail(program, OUT_OF_MEMORY, UNREADABLE);
    } catch (const std::exception& e) {
        return fail(program, sentence(e), UNREADABLE);
    }
}
}  // namespace voxeland::apps
