// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <exception>
#include <functional>
#include <string>

namespace voxeland::apps
{
/** What an exception says, in one line: MRPT wraps its messages in a title and the call stack. */
std::string sentence(const std::exception& e);

/** Runs a program's body; an exception becomes one sentence on stderr and its exit code (see
 *  voxeland/errors.h; 3 for anything else that MRPT or a library threw while reading).
 *  \return exit code of the program */
int runProgram(const char* program, const std::function<int()>& body);
}  // namespace voxeland::apps
