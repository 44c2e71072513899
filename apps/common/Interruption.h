// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland::apps
{
/** Exit code of a program that the user stopped, by Ctrl-C or SIGTERM. */
constexpr int INTERRUPTED = 130;

/** Lets a program end in good order when the user stops it. While an object of this class lives,
 * the first SIGINT or SIGTERM is only noted: the program asks wasRequested() now and then, saves
 * what it has and returns INTERRUPTED. The second one ends the program at once. One object at a
 * time. */
class Interruption
{
 public:
    Interruption();
    /** Both signals end the program again. */
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /** Whether the user asked to stop. May be called from any thread. */
    [[nodiscard]] bool wasRequested() const;
};
}  // namespace voxeland::apps
