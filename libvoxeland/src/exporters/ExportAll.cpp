// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/exporters/ExportAll.h"

#include "InstancesCsv.h"
#include "InstancesJson.h"
#include "MapPly.h"
#include "pictures/MapViews.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/level/UpDirection.h"

namespace voxeland
{
void checkExportFolder(const std::string& folder)
{
    makeOutputFolder(folder);
    checkWritable(folder + "/map.ply");
}

void exportAll(const SemanticVoxelMap& map, const std::string& folder, WrittenFiles& written)
{
    makeOutputFolder(folder);
    const LevelFrame frame(estimateUp(map));
    const auto write = [&](const char* name, const auto& exporter) {
        const std::string file = folder + "/" + name;
        exporter(file);
        written.add(file);
    };
    ViewOptions options;
    options.up = frame.axes()[2];
    try {
        write("map.ply", [&](const std::string& file) { exportPly(map, file); });
        write("instances.json", [&](const std::string& file) { exportJson(map, frame, file); });
        write("instances.csv", [&](const std::string& file) { exportCsv(map, frame, file); });
        exportViews(map, folder, written, options);
    } catch (const OutputError& e) {
        throw OutputError(e.what() + written.told());
    }
}
}  // namespace voxeland
