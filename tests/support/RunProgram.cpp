// SPDX-License-Identifier: BSD-3-Clause
#include "support/RunProgram.h"

#include "support/TestFiles.h"

#include <cstdlib>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace voxeland::test
{
namespace
{
std::string quoted(const std::string& text)
{
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}
}  // namespace

ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments)
{
    return runProgramIn(".", program, arguments);
}

ProgramResult runProgramIn(const std::string& folder, const std::string& program,
                           const std::vector<std::string>& arguments)
{
    const TemporaryFolder captured;
    const fs::path ours = fs::path(VOXELAND_TEST_BINARY_DIR) / "bin" / program;
    std::string command = "cd " + quoted(folder) + " && ";
    command += quoted(fs::exists(ours) ? ours.string() : program);
    for (const auto& a : arguments) command += " " + quoted(a);
    command +=
        " </dev/null >" + quoted(captured.file("out")) + " 2>" + quoted(captured.file("err"));
    const int status = std::system(command.c_str());
    ProgramResult result;
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    result.output = readFile(captured.file("out"));
    result.errors = readFile(captured.file("err"));
    return result;
}
}  // namespace voxeland::test
