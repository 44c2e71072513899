// SPDX-License-Identifier: BSD-3-Clause
#include "common/Interruption.h"

#include "common/Signals.h"

#include <atomic>

namespace voxeland::apps
{
namespace
{
std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

extern "C" void noteInterruption(int)
{
    requested = true;
    handleEndingSignals(endBySignal);  // a second one ends the program at once
}
}  // namespace

Interruption::Interruption()
{
    requested = false;
    handleEndingSignals(noteInterruption);
}

Interruption::~Interruption()
{
    handleEndingSignals(endBySignal);
}

bool Interruption::wasRequested() const
{
    return requested;
}
}  // namespace voxeland::apps
