// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "planning/Reobservation.h"
#include "voxeland/answers/MapAnswers.h"

/** \file
 * Answers of a map for people to read, and for programs as JSON (units as in
 * instancesAsJson()). All end with a line break. */
namespace voxeland
{
std::string asText(const MapOverview& overview);
/** A table. \param withDistance show FoundInstance::distance \param prior show vacuity, which says
 *  something only in maps with a prior */
std::string asText(const std::vector<FoundInstance>& instances, bool withDistance, bool prior);
/** Names the likeliest categories only. */
std::string asText(const PlaceAnswer& answer);
std::string asText(const std::vector<ReobservationTarget>& targets);

/** Keys as the members of MapOverview in small letters, and `map` as in instancesAsJson(). */
std::string asJson(const SemanticVoxelMap& map, const MapOverview& overview);
/** A list of the `objN` values of instancesAsJson(), each with its `distance`. */
std::string asJson(const SemanticVoxelMap& map, const std::vector<FoundInstance>& instances);
std::string asJson(const PlaceAnswer& answer);
/** A list of `{"kind": "instance" or "region", "id", "category", "uncertainty", "voxels", "center",
 *  "poses": [{"position": [x,y,z], "yaw", "pitch", "distance", "visible", "matrix": 4 rows}]}`, the
 *  most uncertain first; regions have neither id nor category. Poses as in CameraPose. */
std::string asJson(const std::vector<ReobservationTarget>& targets);
}  // namespace voxeland
