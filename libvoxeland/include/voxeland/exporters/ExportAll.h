// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/files/WrittenFiles.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>

namespace voxeland
{
/** Writes map.ply, instances.json, instances.csv and the pictures of exportViews() into a folder.
 *  \param folder made if missing
 *  \param written those completed are added to it
 *  \throws OutputError if one of them cannot be written, with the names of those written */
void exportAll(const SemanticVoxelMap& map, const std::string& folder, WrittenFiles& written);

/** Makes the folder of exportAll(), and makes sure that files can be written into it.
 *  \throws OutputError if not */
void checkExportFolder(const std::string& folder);
}  // namespace voxeland
