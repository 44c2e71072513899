// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::test
{
/** What a program that was run left behind. */
struct ProgramResult
{
    int exitCode = -1;  //!< -1 if it did not end by itself
    std::string output, errors;
};

/** Runs a program, without a terminal, and waits for its end.
 *  \param program name of one of ours (in build/bin), or of one in the PATH */
ProgramResult runProgram(const std::string& program, const std::vector<std::string>& arguments);

/** As runProgram(), with this as the current folder. */
ProgramResult runProgramIn(const std::string& folder, const std::string& program,
                           const std::vector<std::string>& arguments);
}  // namespace voxeland::test
