// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "ThreeLibrary.h"
#include "voxeland/map/MappingCounts.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** What a report says besides the map itself. */
struct ReportOptions
{
    std::string title = "Voxeland map";
    /** Up in the map's frame, of any length > 0; not given: estimateUp(). */
    std::optional<mrpt::math::TVector3D> up;
    std::string timing;      //!< TimingLog::printSummary(); empty: no such section
    std::string evaluation;  //!< EvaluationReport::text(); empty: no such section
};

/** A page that shows a map to somebody who has never heard of it: its voxels in 3D, to be turned,
 *  and coloured by instance, category or uncertainty; its instances as a table; pictures; figures.
 *  One HTML file that needs no network: libraries, data and pictures are inside.
 *  \param three draws in 3D
 *  \throws ConfigurationError for a map wider than 65535 voxels */
std::string reportAsHtml(const SemanticVoxelMap& map, const MappingCounts& counts,
                         const ReportOptions& options, const ThreeLibrary& three);
}  // namespace voxeland
