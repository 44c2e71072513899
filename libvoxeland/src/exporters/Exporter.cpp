// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/exporters/Exporter.h"

#include "GlbFile.h"
#include "GridFiles.h"
#include "InstancesCsv.h"
#include "InstancesJson.h"
#include "MapPly.h"
#include "MapScene.h"
#include "OctoMapFile.h"
#include "PicturesFolder.h"
#include "PointsFile.h"
#include "base/ClassicNumbers.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/lowerCase.h"

#include <algorithm>
#include <filesystem>

namespace voxeland
{
const std::vector<Exporter>& exporters()
{
    static const std::vector<Exporter> all = {
        plyExporter(),    plyPerInstanceExporter(), jsonExporter(),    csvExporter(),
        glbExporter(),    sceneExporter(),          octoMapExporter(), gridmapExporter(),
        rosMapExporter(), pointsExporter(),         picturesExporter()};
    return all;
}

void checkEnding(const Exporter& exporter, const std::string& output)
{
    const auto has = [](const std::vector<std::string>& endings, const std::string& ending) {
        return std::any_of(endings.begin(), endings.end(), [&](const std::string& known) {
            return lowerCase(known) == lowerCase(ending);
        });
    };
    if (exporter.endings.empty()) return;
    const std::string own = std::filesystem::path(output).extension().string();
    const auto known = [&](const Exporter& e) { return has(e.endings, own); };
    // Not written, but known for what they are.
    const bool isKnown = has({".gltf", ".obj", ".pgm", ".png", ".voxeland"}, own) ||
                         std::any_of(exporters().begin(), exporters().end(), known);
    if (isKnown && !known(exporter))
        throw ConfigurationError("--" + exporter.name + " '" + output + "' must end in " +
                                 joined(exporter.endings, " or ") + ", which is what it writes");
}

HeightRange heightsInFrame(const SemanticVoxelMap& map, const ExportSettings& settings,
                           const HeightRange& otherwise)
{
    const HeightRange heights = settings.heights.value_or(otherwise);
    const double floor = floorHeight(map, settings.frame);
    const auto& up = settings.frame.axes()[2];
    settings.note(format("heights are along (%.3f, %.3f, %.3f), from %.2f m", up.x, up.y, up.z,
                         floor + map.origin().z));
    return {floor + heights.low, floor + heights.high};
}
}  // namespace voxeland
