// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/ExportAll.h"

#include "voxeland/io/AtomicFile.h"
#include "voxeland/io/InstancesCsv.h"
#include "voxeland/io/InstancesJson.h"
#include "voxeland/io/MapPly.h"
#include "voxeland/io/MapViews.h"
#include "voxeland/io/OutputFolder.h"
#include "voxeland/io/UpDirection.h"

namespace voxeland
{
void checkExportFolder(const std::string& folder)
{
    makeOutputFolder(folder);
    checkWritable(folder + "/map.ply");
}

std::vector<std::string> exportAll(const SemanticVoxelMap& map, const std::string& folder)
{
    makeOutputFolder(folder);
    std::vector<std::string> files = {folder + "/map.ply", folder + "/instances.json",
                                      folder + "/instances.csv"};
    exportPly(map, files[0]);
    const LevelFrame frame(estimateUp(map));
    exportJson(map, frame, files[1]);
    exportCsv(map, frame, files[2]);
    ViewOptions options;
    options.up = frame.axes()[2];
    const auto views = exportViews(map, folder, options);
    files.insert(files.end(), views.begin(), views.end());
    return files;
}
}  // namespace voxeland
