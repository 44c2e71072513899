// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/io/LevelFrame.h"

#include <set>
#include <string>

namespace voxeland
{
/** Which voxels become points. */
struct PointsFilter
{
    std::set<std::string> categories;  //!< most probable one of the winning instance, or
                                       //!< UNKNOWN_CATEGORY; case is ignored; empty: all
    LevelFrame frame;                  //!< where heights are measured
    HeightRange heights;               //!< [m]
};

/** Writes the centres of occupied voxels, in the map's frame, as an `mrpt::maps::CSimplePointsMap`:
 *  - `.txt`: a line `x y z` each, as its load3D_from_text_file() reads;
 *  - `.metricmap`: serialized and compressed, as mrpt_map_server reads;
 *  - `.3Dscene`: for SceneViewer3D.
 *
 *  \return how many points there are
 *  \throws ConfigurationError for another ending, OutputError if the file cannot be written */
size_t exportPoints(const SemanticVoxelMap& map, const PointsFilter& filter,
                    const std::string& file);
}  // namespace voxeland
