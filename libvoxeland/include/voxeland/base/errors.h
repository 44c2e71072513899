// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>

/** \file
 * The ways a run can fail. The library throws them, each with one sentence that says what
 * went wrong, where, and what to do; programs turn them into the exit codes given here. */
namespace voxeland
{
/** Wrong usage or configuration: exit code 1. */
struct ConfigurationError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
/** A plugin or one of its classes cannot be used: exit code 2. */
struct PluginError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
/** A disambiguation back-end could not be asked: exit code 2, like other plugins. */
struct DisambiguationError : PluginError
{
    DisambiguationError(const std::string& sentence, bool noOtherQuestionEither)
        : PluginError(sentence), fatal(noOtherQuestionEither)
    {
    }
    bool fatal;  //!< no other question can be asked either (wrong key, server down)
};
/** Input that cannot be read or is corrupt: exit code 3. */
struct InputError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
/** Input that holds nothing to map: exit code 4. */
struct NothingToMapError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
/** Output that cannot be written: exit code 5. */
struct OutputError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
}  // namespace voxeland
