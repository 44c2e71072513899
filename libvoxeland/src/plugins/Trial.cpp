// SPDX-License-Identifier: BSD-3-Clause
#include "Trial.h"

#include "voxeland/base/printable.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <link.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace voxeland
{
namespace
{
using Header = ElfW(Ehdr);

constexpr int THROWN = 113;  // exit code of a child in which an exception was thrown

/** In a child: tries, and tells what was thrown. */
[[noreturn]] void tryOut(const std::function<void()>& action, int report)
{
    const int nowhere = open("/dev/null", O_WRONLY);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    alarm(TRIAL_SECONDS);
    try {
        action();
        _exit(0);
    } catch (const std::exception& e) {
        const std::string text = printable(e.what());
        static_cast<void>(!write(report, text.data(), text.size()));
    } catch (...) {
    }
    _exit(THROWN);
}

std::string readAll(int file)
{
    std::string text(1000, '\0');
    const ssize_t bytes = read(file, text.data(), text.size());
    text.resize(static_cast<size_t>(std::max<ssize_t>(0, bytes)));
    return text;
}

/** Reads a header of a file. \return whether it is all there */
template <typename T>
bool readAt(std::istream& in, uint64_t at, T& header)
{
    in.seekg(static_cast<std::streamoff>(at));
    return static_cast<bool>(in.read(reinterpret_cast<char*>(&header), sizeof(header)));
}

bool isWithin(uint64_t begin, uint64_t size, uint64_t end)
{
    return begin <= end && size <= end - begin;
}

/** The header of this library. */
Header ownHeader()
{
    Dl_info info;
    Header header{};
    if (dladdr(reinterpret_cast<const void*>(&libraryProblem), &info) != 0)
        std::memcpy(&header, info.dli_fbase, sizeof(header));
    return header;
}
}  // namespace

std::string failureInTrial(const std::function<void()>& action)
{
    int report[2];
    if (pipe2(report, O_CLOEXEC) != 0) return {};
    std::fflush(nullptr);
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0) tryOut(action, report[1]);
    close(report[1]);
    const std::string thrown = child < 0 ? std::string() : readAll(report[0]);
    close(report[0]);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return {};
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
        return "takes longer than " + std::to_string(TRIAL_SECONDS) + " s";
    if (WIFSIGNALED(status))
        return std::string("ends the program (") + strsignal(WTERMSIG(status)) + ")";
    if (WEXITSTATUS(status) == 0) return {};
    if (WEXITSTATUS(status) != THROWN)
        return "ends the program with exit code " + std::to_string(WEXITSTATUS(status));
    return "throws an exception" + (thrown.empty() ? "" : ": " + thrown);
}

std::string libraryProblem(const std::string& file)
{
    std::error_code error;
    const uint64_t size = std::filesystem::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    Header header;
    if (error || !readAt(in, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
        header.e_type != ET_DYN)
        return "is no shared library";
    const Header own = ownHeader();
    if (header.e_ident[EI_CLASS] != own.e_ident[EI_CLASS] ||
        header.e_ident[EI_DATA] != own.e_ident[EI_DATA] || header.e_machine != own.e_machine)
        return "is a library for another kind of machine";
    const bool hasSections =
        isWithin(header.e_shoff, uint64_t{header.e_shnum} * header.e_shentsize, size);
    bool isWhole = hasSections && header.e_phentsize == sizeof(ElfW(Phdr));
    for (uint64_t i = 0; isWhole && i < header.e_phnum; ++i) {
        ElfW(Phdr) segment;
        isWhole = readAt(in, header.e_phoff + i * sizeof(segment), segment) &&
                  (segment.p_type != PT_LOAD || isWithin(segment.p_offset, segment.p_filesz, size));
    }
    return isWhole ? "" : "is cut off";
}
}  // namespace voxeland
