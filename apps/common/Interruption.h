// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace voxeland::apps
{
/** Exit code of a program that the user stopped, by Ctrl-C, SIGTERM or SIGHUP. */
constexpr int INTERRUPTED = 130;

/** Thrown to end so, with what was kept and how to go on: printed by runProgram(). */
struct Interrupted : std::runtime_error
{
    /** \param goesOn command that goes on, see asTyped(); empty: none is shown */
    explicit Interrupted(const std::string& sentence, std::string goesOn = "")
        : std::runtime_error(sentence), command(std::move(goesOn))
    {
    }
    std::string command;
};

/** Lets a program end in good order when the user stops it. While an object of this class lives,
 * the first SIGINT, SIGTERM or SIGHUP is only noted: the program asks wasRequested() now and then,
 * saves what it has and throws Interrupted. The second one ends the program at once, see
 * endBySignal(). One object at a time. */
class Interruption
{
 public:
    Interruption();
    /** The signals end the program again. */
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /** Whether the user asked to stop. May be called from any thread. */
    [[nodiscard]] bool wasRequested() const;
};
}  // namespace voxeland::apps
