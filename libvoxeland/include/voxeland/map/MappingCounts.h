// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace voxeland
{
/** What went into a map, and what did not. */
struct MappingCounts
{
    uint32_t frames = 0;                    //!< frames integrated
    uint32_t framesWithoutPredictions = 0;  //!< of those, frames mapped without any opinion source
    uint32_t opinions = 0;                  //!< opinions integrated
    uint32_t framesWithoutPose = 0;         //!< frames skipped: no valid pose was known for them
    uint32_t predictionsWithoutFrame = 0;   //!< predictions left out: no frame of their timestamp
    uint32_t merges = 0, splits = 0;        //!< of instances, during refinement
};
}  // namespace voxeland
