// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <optional>

namespace voxeland
{
/** Adds a decision to its instance. Its evidence is set, so that the probability of its category
 * becomes what Bayes' rule makes of the map's and of a witness who is right in the share
 * `answer_reliability` r of cases, and otherwise says any of the `max_categories` n other answers:
 *
 *      p r / (p r + (1 - p) (1 - r) / n)
 *
 * with p = r p_map + (1 - r) / (n + 1), as the map may be as wrong as the witness. So one answer
 * decides where the map is unsure, not where it is sure, and two that agree count more than one. */
void decide(SemanticVoxelMap& map, instance_id_t instance, Decision decision,
            const DisambiguationOptions& options);

/** Takes decisions back: the map is then, byte by byte, as if they had never been made.
 *  \param instance its id, or one that was merged into it; not given: all instances
 *  \return number of decisions taken back */
size_t undoDecisions(SemanticVoxelMap& map, std::optional<instance_id_t> instance);
}  // namespace voxeland
