// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/printable.h"

#include <iostream>
#include <string>

namespace voxeland::apps
{
/** Says one sentence on stderr; the one way there. */
inline void say(const std::string& text, size_t maxLength)
{
    std::cerr << printableSentence(text, maxLength) << "\n";
}
}  // namespace voxeland::apps
