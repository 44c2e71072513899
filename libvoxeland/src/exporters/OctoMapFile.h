// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>

namespace voxeland
{
/** Writes the occupancy of all observed voxels as an octree of the OctoMap library, in the map's
 *  frame: `.bt` tells free from occupied, `.ot` holds probabilities.
 *  \throws ConfigurationError for another ending, or a map wider than an OctoMap can be (65536
 *  voxels); OutputError if the file cannot be written */
void exportOctoMap(const SemanticVoxelMap& map, const std::string& file);

/** exportOctoMap(). */
Exporter octoMapExporter();
}  // namespace voxeland
