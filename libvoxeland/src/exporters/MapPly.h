// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/files/WrittenFiles.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <string>
#include <vector>

namespace voxeland
{
/** Writes the voxels as a binary little-endian PLY point cloud, one vertex a voxel:
 *  - `x y z` (float): centre in the world [m]; of type double where the map has an origin of its
 * own;
 *  - `red green blue` (uchar): that of the instance which wins the voxel, see instanceColors();
 *  - `instanceid` (int): that instance, 0 for *unknown*;
 *  - `categoryid` (int): its most probable category, -1 if none; the header names them in lines
 *    `comment category 3 dining table`;
 *  - `occupancy` (float): probability in (0,1);
 *  - `uncertainty_instances` (float): H(I_v) of the voxel [nat];
 *  - `uncertainty_categories` (float): H(C_k) of the winning instance [nat], 0 for *unknown*;
 *  - `uncertainty_semantic` (float): H(C_v), category by total probability [nat].
 *
 *  \param occupiedOnly leave out voxels that were measured once but are now believed free
 *  \throws OutputError if the file cannot be written */
void exportPly(const SemanticVoxelMap& map, const std::string& file, bool occupiedOnly = true);

/** Writes the voxels that each instance wins as a PLY file of its own, named `ID_CATEGORY.ply`,
 *  and those of *unknown* as `0_unknown.ply`.
 *  \param folder made if missing
 *  \param written those completed are added to it
 *  \throws OutputError if one of them cannot be written */
void exportPlyPerInstance(const SemanticVoxelMap& map, const std::string& folder,
                          WrittenFiles& written, bool occupiedOnly = true);

/** exportPly() and exportPlyPerInstance(). */
Exporter plyExporter();
Exporter plyPerInstanceExporter();
}  // namespace voxeland
