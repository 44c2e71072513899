// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/errors.h"

namespace voxeland
{
/** A frame cannot be used, the rest of the input being fine: it is left out and counted. */
struct UnusableFrame : InputError
{
    using InputError::InputError;
};
}  // namespace voxeland
