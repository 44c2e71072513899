// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>

/** \file
 * Why an instance is what a map takes it for: evidence of each category, and which views,
 * merges, splits and decisions brought it. */
namespace voxeland
{
/** To be read; ends with a line break. \param id of a live instance */
std::string explanationAsText(const SemanticVoxelMap& map, instance_id_t id);

/** Keys: `id`, `category`, `probability`, `entropy`, `voxels`, `observations`, `first_frame`,
 * `last_frame`, `evidence` (by category:
 * `detectors`, `decisions`, `probability`), `views` (by category), `history`, `decisions`. */
std::string explanationAsJson(const SemanticVoxelMap& map, instance_id_t id);
}  // namespace voxeland
