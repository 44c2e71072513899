// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

namespace voxeland
{
/** Runs something in a child process, silently, to see whether it would end this one: by a signal,
 *  an exit, an exception or by taking more than TRIAL_SECONDS.
 *  \return what it does then, as "ends the program (Aborted)"; empty if it passes, or if no child
 *  can be had */
std::string failureInTrial(const std::function<void()>& action);

constexpr unsigned TRIAL_SECONDS = 30;

/** What is wrong with a file as a shared library of this machine, as its headers say: "is no shared
 *  library", "is one of another machine" or "is cut off"; empty if nothing is. A library that is
 *  cut off would crash the program where it is loaded. */
std::string libraryProblem(const std::string& file);
}  // namespace voxeland
