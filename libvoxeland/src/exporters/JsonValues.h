// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/OrientedBox.h"
#include "voxeland/map/MapQueries.h"

#include <nlohmann/json.hpp>

namespace voxeland
{
/** JSON whose keys stay in the order they were given. */
using json_t = nlohmann::ordered_json;

json_t toJson(const mrpt::math::TPoint3D& p);
/** The value of one `objN`, see instancesAsJson(). */
json_t toJson(const SemanticVoxelMap& map, const InstanceSummary& summary, const OrientedBox& box);
/** The value of `map`, see instancesAsJson(). */
json_t mapAsJson(const SemanticVoxelMap& map);
/** As text, indented; bytes that are no UTF-8 are replaced. */
std::string toText(const json_t& json);
}  // namespace voxeland
