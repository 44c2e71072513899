// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/exporters/ExportAll.h"

#include "voxeland/base/errors.h"
#include "voxeland/exporters/Exporter.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/level/UpDirection.h"

namespace voxeland
{
void checkExportFolder(const std::string& folder)
{
    makeOutputFolder(folder);
    for (const Exporter& exporter : exporters())
        if (exporter.nameInAll && !exporter.nameInAll->empty())
            checkWritable(folder + "/" + *exporter.nameInAll);
}

void exportAll(const SemanticVoxelMap& map, const std::string& folder, WrittenFiles& written)
{
    makeOutputFolder(folder);
    ExportSettings settings;
    settings.frame = GravityAlignedFrame(estimateUp(map));
    try {
        for (const Exporter& exporter : exporters())
            if (exporter.nameInAll) {
                const std::string& name = *exporter.nameInAll;
                exporter.write(map, settings, name.empty() ? folder : folder + "/" + name, written);
            }
    } catch (const OutputError& e) {
        throw OutputError(e.what() + written.told());
    }
}
}  // namespace voxeland
