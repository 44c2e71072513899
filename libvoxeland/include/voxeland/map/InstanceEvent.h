// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/VoxelEvidence.h"

namespace voxeland
{
/** A merge or a split that made an instance what it is. */
struct InstanceEvent
{
    enum class Kind : uint8_t
    {
        merged,  //!< `instance` took over `other`
        divided  //!< `other` was separated from `instance`
    };

    Kind kind = Kind::merged;
    uint32_t frame = 0;  //!< number of the frame after which it happened, from 0
    instance_id_t instance = UNKNOWN_INSTANCE, other = UNKNOWN_INSTANCE;
};
}  // namespace voxeland
