// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"

#include <string>

namespace voxeland
{
/** A frame cannot be used, the rest of the input being fine: it is left out and counted. */
struct UnusableFrame : InputError
{
    /** \throws std::bad_alloc if memory was refused: the frame may be fine */
    explicit UnusableFrame(const std::string& sentence) : InputError(sentence)
    {
        RefusedMemory::check();
    }
};
}  // namespace voxeland
