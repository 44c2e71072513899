// SPDX-License-Identifier: BSD-3-Clause
#include "GridFiles.h"

#include "files/GzOutputFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/files/AtomicFile.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
HeightSlice sliceOf(const SemanticVoxelMap& map, const ExportSettings& settings)
{
    constexpr HeightRange BODY{0.1, 1.8};
    return inWorld(sliceOf(map, settings.frame, heightsInFrame(map, settings, BODY)), map);
}
}  // namespace

void exportGridmap(const HeightSlice& slice, const std::string& file)
{
    writeAtomically(file, gridOf(slice));
}

std::string rosImageOf(const std::string& yamlFile)
{
    const fs::path yaml(yamlFile);
    if (yaml.extension() != ".yaml")
        throw ConfigurationError("'" + yamlFile + "' must end in .yaml");
    return fs::path(yaml).replace_extension(".pgm").string();
}

void exportRosMap(const HeightSlice& slice, const std::string& yamlFile, WrittenFiles& written)
{
    const std::string image = rosImageOf(yamlFile);
    writeAtomically(image, [&](std::ostream& out) {
        out << "P5\n" << slice.columns << " " << slice.rows << "\n255\n";
        for (size_t row = slice.rows; row-- > 0;)
            for (size_t column = 0; column < slice.columns; ++column) {
                constexpr unsigned char OCCUPIED = 0, FREE = 254, UNKNOWN = 205;
                const float p = slice.occupancy[row * slice.columns + column];
                out.put(static_cast<char>(p > 0.5F ? OCCUPIED : p < 0.5F ? FREE : UNKNOWN));
            }
    });
    written.add(image);
    writeAtomically(yamlFile, [&](std::ostream& out) {
        out << "image: " << fs::path(image).filename().string()
            << "\nresolution: " << numberText(slice.resolution) << "\norigin: ["
            << metresText(slice.minX) << ", " << metresText(slice.minY) << ", 0.0]"
            << "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    });
    written.add(yamlFile);
}

Exporter gridmapExporter()
{
    Exporter e{"gridmap", "FILE.gridmap", "Slice of some heights as an MRPT occupancy grid"};
    e.endings = {".gridmap"};
    e.takesHeights = true;
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportGridmap(sliceOf(map, settings), file);
        written.add(file);
    };
    return e;
}

Exporter rosMapExporter()
{
    Exporter e{"ros-map", "FILE.yaml",
               "Slice of some heights for ROS's map_server, with a .pgm beside it"};
    e.endings = {".yaml"};
    e.takesHeights = true;
    e.beside = rosImageOf;
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file,
                 WrittenFiles& written) { exportRosMap(sliceOf(map, settings), file, written); };
    return e;
}
}  // namespace voxeland
