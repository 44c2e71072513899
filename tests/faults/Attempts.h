// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Faults.h"

#include <functional>
#include <string>

namespace voxeland::test
{
/** How a piece of work ended that was done in a process of its own. */
struct Attempt
{
    int exitCode = -1;    //!< as a program's that does it; -1: ended by a signal
    int signal = 0;       //!< which
    std::string message;  //!< the sentence of an exception
    unsigned call = 0;    //!< which call was to fail, from 1
    unsigned calls = 0;   //!< of that kind there were; 0 if a signal ended it
};

/** Whether this machine lets a process trace its children, as Calls::system needs. */
bool canTrace();

/** Does work that calls fail in. The process that tries must have no threads. */
Attempt attempt(Calls kind, unsigned n, int error, unsigned times,
                const std::function<void()>& work);

/** Does work again and again, in which the first call of a kind fails, the second, and so on.
 *  \param most attempts: where there are more calls, one of so many fails
 *  \param afterwards looks at what each attempt left
 *  \return attempts */
unsigned attemptAll(Calls kind, int error, unsigned times, unsigned most,
                    const std::function<void()>& work,
                    const std::function<void(const Attempt&)>& afterwards);
}  // namespace voxeland::test
