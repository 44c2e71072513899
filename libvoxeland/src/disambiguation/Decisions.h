// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <optional>

namespace voxeland
{
/** Adds a decision to its instance. Its evidence is set: as a multiple (`decision_weight`) of all
 * evidence the instance has, prior included, so that with more than 1 the category wins whatever
 * the others have. */
void decide(SemanticVoxelMap& map, instance_id_t instance, Decision decision,
            const DisambiguationOptions& options);

/** Takes decisions back: the map is then, byte by byte, as if they had never been made.
 *  \param instance its id, or one that was merged into it; not given: all instances
 *  \return number of decisions taken back */
size_t undoDecisions(SemanticVoxelMap& map, std::optional<instance_id_t> instance);
}  // namespace voxeland
