// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <string>

namespace voxeland
{
/** Writes a table of the instances that win at least one occupied voxel (RFC 4180: commas, a header
 *  line, names quoted where needed). Columns: id, category, probability, entropy, vacuity,
 *  geometric_entropy, observations, voxels, centroid_x|y|z, min_x|y|z and max_x|y|z (axis-aligned
 *  box), box_x|y|z, box_length, box_width, box_height, box_yaw (OrientedBox). Metres, radians,
 *  nats. \param frame tells where up is \throws OutputError if the file cannot be written */
void exportCsv(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
               const std::string& file);

/** exportCsv(). */
Exporter csvExporter();
}  // namespace voxeland
