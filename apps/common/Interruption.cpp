// SPDX-License-Identifier: BSD-3-Clause
#include "common/Interruption.h"

#include <atomic>
#include <csignal>

namespace voxeland::apps
{
namespace
{
constexpr int SIGNALS[] = {SIGINT, SIGTERM};

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

void handleBy(void (*handler)(int))
{
    for (const int signal : SIGNALS) std::signal(signal, handler);
}

extern "C" void noteInterruption(int)
{
    requested = true;
    handleBy(SIG_DFL);  // a second one ends the program at once
}
}  // namespace

Interruption::Interruption()
{
    requested = false;
    handleBy(noteInterruption);
}

Interruption::~Interruption()
{
    handleBy(SIG_DFL);
}

bool Interruption::wasRequested() const
{
    return requested;
}
}  // namespace voxeland::apps
