// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <string>

namespace voxeland
{
/** Writes the occupied voxels as a binary glTF 2.0 file. Each instance is a node named like "chair
 *  3", with its id, category, probability and entropy in `extras`; what belongs to none is the node
 *  "unknown". Its mesh, in the map's frame, has the faces of its voxels that are not covered by
 *  another one of them, those side by side in a plane as one rectangle. The root node turns the map
 * so that up is +y, as glTF wants it. \param frame tells where up is \throws ConfigurationError for
 * a map of more than 4 GB of faces \throws OutputError if the file cannot be written */
void exportGlb(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
               const std::string& file);

/** exportGlb(). */
Exporter glbExporter();
}  // namespace voxeland
