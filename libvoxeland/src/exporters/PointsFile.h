// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <set>
#include <string>

namespace mrpt::maps
{
class CSimplePointsMap;
}

namespace voxeland
{
/** Which voxels become points. A voxel's category is the most probable one of the instance that
 *  wins it, or UNKNOWN_CATEGORY. */
struct PointsFilter
{
    std::set<std::string> categories;  //!< only these or their plurals, see NameFit; empty: all
    std::set<std::string> except;      //!< not these, such as people: they will have moved on
    GravityAlignedFrame frame;         //!< where heights are measured
    HeightRange heights;               //!< [m]
};

/** The centres of occupied voxels, in the world: obstacles for MRPT's reactive navigation.
 *  \throws ConfigurationError where floats lack the digits for their places */
mrpt::maps::CSimplePointsMap pointsOf(const SemanticVoxelMap& map, const PointsFilter& filter);

/** Writes pointsOf():
 *  - `.txt`: a line `x y z` each, as its load3D_from_text_file() reads;
 *  - `.metricmap`: serialized and compressed, as mrpt_map_server reads;
 *  - `.3Dscene`: for SceneViewer3D.
 *
 *  \return how many points there are
 *  \throws ConfigurationError for another ending, OutputError if the file cannot be written */
size_t exportPoints(const SemanticVoxelMap& map, const PointsFilter& filter,
                    const std::string& file);

/** exportPoints() of what the settings choose. */
Exporter pointsExporter();
}  // namespace voxeland
