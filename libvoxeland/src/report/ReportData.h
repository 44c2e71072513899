// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "MapReport.h"

#include <string>

namespace voxeland
{
/** What table.js and scene.js draw, as JSON text on one line:
 *  - `title`, `timing`, `evaluation`: texts, the latter two may be empty;
 *  - `summary`: list of pairs of texts;
 *  - `resolution` [m], `azimuth` (MapViews::azimuth);
 *  - `axes`: the gravity-aligned frame's axes in the map's frame;
 *  - `origin`: smallest voxel coordinates; `voxels`: their number;
 *  - `positions`: voxel coordinates from `origin` on, 3 x uint16 each; `owners`: uint32, 0 for
 *    *unknown* or 1 + index in `instances`; `doubts`: uint8, entropy over instances, 255 being
 *    `scale`: all in base64, little-endian;
 *  - `scale`: the largest entropy that colours tell apart [nat]; `ramp`: its 64 colours;
 *  - `unknown`: colour of *unknown*;
 *  - `instances`: those with an occupied voxel, the biggest first;
 *  - `pictures`: list of `title` and `png` (base64). */
std::string reportData(const SemanticVoxelMap& map, const MappingCounts& counts,
                       const ReportOptions& options);
}  // namespace voxeland
