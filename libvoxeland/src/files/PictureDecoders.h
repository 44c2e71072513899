// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace voxeland
{
/** How many pictures this thread has decoded of which libjpeg says that their bytes are damaged:
 *  parts of them are grey or of wrong colours. */
uint64_t damagedPictures();
}  // namespace voxeland
