// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>
#include <vector>

namespace voxeland
{
/** Writes map.ply, instances.json, instances.csv and the pictures of exportViews() into a folder.
 *  \param folder made if missing
 *  \return the files written \throws OutputError if one of them cannot be */
std::vector<std::string> exportAll(const SemanticVoxelMap& map, const std::string& folder);

/** Makes the folder of exportAll(), and makes sure that files can be written into it.
 *  \throws OutputError if not */
void checkExportFolder(const std::string& folder);
}  // namespace voxeland
