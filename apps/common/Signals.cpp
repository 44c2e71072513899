// SPDX-License-Identifier: BSD-3-Clause
#include "common/Signals.h"

#include "files/OutputPart.h"

#include <csignal>

namespace voxeland::apps
{
namespace
{
/** Handled instead of ignored: a program that voxeland-run starts would go on ignoring it. */
extern "C" void leaveToWriter(int) {}
}  // namespace

void handleEndingSignals(SignalHandler handler)
{
    constexpr int SIGNALS[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action
    {
    };
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    for (const int signal : SIGNALS) sigaddset(&action.sa_mask, signal);
    for (const int signal : SIGNALS) {
        struct sigaction before
        {
        };
        const bool isHangUp = signal == SIGHUP;
        if (isHangUp && sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
            continue;
        sigaction(signal, &action, nullptr);
    }
}

void endBySignal(int signal)
{
    removeUnfinishedParts();
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // comes as soon as this returns
}

void setUpSignals()
{
    handleEndingSignals(endBySignal);
    std::signal(SIGXFSZ, leaveToWriter);
}
}  // namespace voxeland::apps
