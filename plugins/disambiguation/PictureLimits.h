// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

#include <cstdint>

namespace voxeland
{
/** How large a picture may be. */
struct PictureLimits
{
    uint32_t side = 1024;      //!< of the longer side [pixels]
    uint32_t bytes = 1000000;  //!< of the encoded file
};

/** The picture as it is if it keeps to the limits; otherwise shrunk, as JPEG.
 *  \throws DisambiguationError if it is no picture */
DisambiguationPicture fitted(const DisambiguationPicture& picture, const PictureLimits& limits);
}  // namespace voxeland
