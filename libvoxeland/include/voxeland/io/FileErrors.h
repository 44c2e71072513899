// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>

namespace voxeland
{
/** A file or folder that was given as input is missing, unreadable or corrupt. */
struct UnreadableInput : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/** A file or folder cannot be written: not allowed, disk full, in the way of another. */
struct UnwritableOutput : std::runtime_error
{
    using std::runtime_error::runtime_error;
};
}  // namespace voxeland
