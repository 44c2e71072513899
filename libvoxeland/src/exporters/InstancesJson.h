// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <string>

namespace voxeland
{
/** The instances of a map that win at least one occupied voxel, as JSON text. Metres, radians and
 *  nats; lists of three are x, y, z in the map's frame.
 *  \code{.json}
 *  {"map": {"resolution": 0.05, "frame": "world of the poses ...", "entropy_measure": "expected",
 *           "prior_strength": 0, "categories": ["chair", ...]},
 *   "instances": {"obj1": {
 *     "bbox": {"center": [x,y,z], "size": [x,y,z]},   axis-aligned
 *     "results": {"chair": 7.2, ...},                 evidence beta, the strongest first
 *     "n_observations": 12,                           opinions integrated
 *     "id": 1, "category": "chair", "probability": 0.9,
 *     "probabilities": {"chair": 0.9, ...},           most probable first, with the prior
 *     "entropy": 0.3, "vacuity": 0, "geometric_entropy": 0.1,
 *     "voxels": 321, "centroid": [x,y,z],
 *     "oriented_box": {"center": [x,y,z], "size": [length, width, height], "yaw": 0.5,
 *                      "axes": [[x,y,z], [x,y,z], [x,y,z]]}}, ...}}
 *  \endcode
 *  `bbox`, `results` and `n_observations` are what upstream Voxeland's tools read. The
 *  sides of `oriented_box` go along its `axes`, unit vectors, the last one being up (see
 * OrientedBox). */
std::string instancesAsJson(const SemanticVoxelMap& map, const GravityAlignedFrame& frame);

/** Writes instancesAsJson() to a file. \throws OutputError if that fails */
void exportJson(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                const std::string& file);

/** exportJson(). */
Exporter jsonExporter();
}  // namespace voxeland
