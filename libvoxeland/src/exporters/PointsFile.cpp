// SPDX-License-Identifier: BSD-3-Clause
#include "PointsFile.h"

#include "files/FloatDigits.h"
#include "files/GzOutputFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/map/CategorySearch.h"
#include "voxeland/map/MapQueries.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>

using mrpt::maps::CSimplePointsMap;

namespace voxeland
{
namespace
{
bool anyNames(const std::set<std::string>& names, const std::string& category)
{
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return nameFit(name, category) >= NameFit::plural;
    });
}

/** Instances whose category is wanted, UNKNOWN_INSTANCE possibly among them. */
std::set<instance_id_t> wantedInstances(const SemanticVoxelMap& map, const PointsFilter& filter)
{
    std::set<instance_id_t> wanted;
    const auto consider = [&](instance_id_t id, const std::string& category) {
        const bool isAsked = filter.categories.empty() || anyNames(filter.categories, category);
        if (isAsked && !anyNames(filter.except, category)) wanted.insert(id);
    };
    consider(UNKNOWN_INSTANCE, UNKNOWN_CATEGORY);
    for (const InstanceSummary& s : summarizeInstances(map)) consider(s.id, s.category());
    return wanted;
}

void writeText(const std::string& file, const CSimplePointsMap& points)
{
    writeAtomically(file, [&](std::ostream& out) {
        out << std::fixed << std::setprecision(6);
        for (size_t i = 0; i < points.size(); ++i) {
            float x = 0, y = 0, z = 0;
            points.getPoint(i, x, y, z);
            out << x << ' ' << y << ' ' << z << '\n';
        }
    });
}

mrpt::opengl::COpenGLScene sceneOf(const CSimplePointsMap& points)
{
    mrpt::opengl::COpenGLScene scene;
    scene.insert(points.getVisualization());
    return scene;
}
}  // namespace

CSimplePointsMap pointsOf(const SemanticVoxelMap& map, const PointsFilter& filter)
{
    const std::set<instance_id_t> wanted = wantedInstances(map, filter);
    CSimplePointsMap points;
    const auto insert = [&](const mrpt::math::TPoint3D& p) {
        const auto at = [&](double metres) {
            return asFloat(metres, map.resolution(), "a point map");
        };
        points.insertPoint(at(p.x), at(p.y), at(p.z));
    };
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const auto p = voxelCenter<mrpt::math::TPoint3D>(v, map.resolution());
        if (wanted.count(map.winner(evidence)) > 0 &&
            filter.heights.contains(filter.frame.toLevel(p).z))
            insert(map.inWorld(p));
    });
    return points;
}

size_t exportPoints(const SemanticVoxelMap& map, const PointsFilter& filter,
                    const std::string& file)
{
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending != ".txt" && ending != ".metricmap" && ending != ".3Dscene")
        throw ConfigurationError("'" + file + "' must end in .txt, .metricmap or .3Dscene");
    const CSimplePointsMap points = pointsOf(map, filter);
    if (ending == ".txt")
        writeText(file, points);
    else if (ending == ".metricmap")
        writeAtomically(file, points);
    else
        writeAtomically(file, sceneOf(points));
    return points.size();
}

Exporter pointsExporter()
{
    Exporter e{"points", "FILE",
               "Centres of voxels as an MRPT points map (.txt, .metricmap or .3Dscene)"};
    e.endings = {".txt", ".metricmap", ".3Dscene"};
    e.takesHeights = e.takesCategories = true;
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        PointsFilter filter{settings.categories, settings.except, settings.frame, {}};
        if (settings.heights) filter.heights = heightsInFrame(map, settings, {});
        if (exportPoints(map, filter, file) == 0)
            settings.warn("no voxel is of these categories and heights");
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
