// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland::apps
{
using SignalHandler = void (*)(int);

/** Has the signals by which a user ends a program, SIGINT, SIGTERM and SIGHUP, handled. A SIGHUP
 * that is ignored, as nohup has it, stays so. While one is handled, the others wait. */
void handleEndingSignals(SignalHandler handler);

/** A handler: removes unfinished outputs and ends the program by the signal, as it would have been
 *  without a handler. */
extern "C" void endBySignal(int signal);

/** Sets what holds from the start of a program: endBySignal(), and a file that grows beyond the
 * limit (`ulimit -f`) is an error of writing. */
void setUpSignals();
}  // namespace voxeland::apps
