// SPDX-License-Identifier: BSD-3-Clause
#include "PicturesFolder.h"

#include "pictures/MapViews.h"

namespace voxeland
{
Exporter picturesExporter()
{
    Exporter e{"png-dir", "DIR",
               "Folder for pictures with legends: instances, categories and three uncertainties, "
               "each from the top and in perspective"};
    e.nameInAll = "";
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& folder, WrittenFiles& written) {
        ViewOptions options;
        options.up = settings.frame.axes()[2];
        exportViews(map, folder, written, options);
    };
    return e;
}
}  // namespace voxeland
