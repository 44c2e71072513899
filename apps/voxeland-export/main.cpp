// SPDX-License-Identifier: BSD-3-Clause
/** Writes a map in formats that other programs read. */
#include "base/ClassicNumbers.h"
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "exporters/GlbFile.h"
#include "exporters/GridFiles.h"
#include "exporters/InstancesCsv.h"
#include "exporters/InstancesJson.h"
#include "exporters/MapPly.h"
#include "exporters/MapScene.h"
#include "exporters/OctoMapFile.h"
#include "exporters/PointsFile.h"
#include "pictures/MapViews.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/map/CategorySearch.h"
#include "voxeland/map/SmallInstances.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <mrpt/core/format.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION = R"(Writes a Voxeland map in formats that other programs read.

  voxeland-export -m kitchen.voxeland --png-dir pictures --min-voxels 10
  voxeland-export -m kitchen.voxeland --ply kitchen.ply --json kitchen.json --csv kitchen.csv
  voxeland-export -m kitchen.voxeland --glb kitchen.glb --scene kitchen.3Dscene
  voxeland-export -m flat.voxeland --octomap flat.bt --gridmap flat.gridmap --ros-map flat.yaml
  voxeland-export -m flat.voxeland --points chairs.txt --category chair --height 0.1,1.2
  voxeland-export -m flat.voxeland --points obstacles.metricmap --except person --height 0.1,1.2

At least one output must be named. Existing files are replaced once the new ones are complete.
Coordinates are metres in the map's frame; entropies are in nat. Grids, and nothing else, are in that
frame turned about its origin until up is z, and heights are measured along up from the floor, the
lowest surface that was seen: both are told where they matter.)";

/** What files of known formats end in. */
constexpr const char* ENDINGS[] = {
    ".ply", ".json", ".csv",       ".glb",     ".gltf", ".obj", ".3Dscene", ".bt",
    ".ot",  ".txt",  ".metricmap", ".gridmap", ".yaml", ".pgm", ".png",     ".voxeland"};

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Text up{*this, "--up", "X,Y,Z",
                  "Direction of up in the map's frame (default: +z, or that direction near it in "
                  "which floor and tables are level, or -y in a world with a camera's axes)"};
    apps::Text height{*this, "--height", "LOW,HIGH",
                      "Heights above the floor [m] of --gridmap and --ros-map (default: 0.1,1.8) "
                      "and --points (default: all)"};
    apps::Texts category{*this, "--category", "NAME",
                         "--points: only of this category; may be repeated"};
    apps::Texts except{*this, "--except", "NAME",
                       "--points: not of this category; may be repeated"};
    apps::Number<uint32_t> minVoxels{
        *this, "--min-voxels", "N",
        "Take instances of fewer occupied voxels for unknown, in all outputs", 0};
    apps::Switch all{*this, "--all",
                     "PLY: also voxels that were measured once but are now believed free"};
    apps::Text points{*this, "--points", "FILE",
                      "Centres of voxels as an MRPT points map (.txt, .metricmap or .3Dscene)"};
    apps::Text rosMap{*this, "--ros-map", "FILE.yaml",
                      "Slice of some heights for ROS's map_server, with a .pgm beside it"};
    apps::Text gridmap{*this, "--gridmap", "FILE.gridmap",
                       "Slice of some heights as an MRPT occupancy grid"};
    apps::Text octomap{*this, "--octomap", "FILE.bt",
                       "Occupancy as an OctoMap (.bt, or .ot with probabilities)"};
    apps::Text glb{*this, "--glb", "FILE.glb",
                   "Binary glTF: voxels as a coloured mesh, a node for each instance"};
    apps::Text scene{*this, "--scene", "FILE.3Dscene",
                     "Voxels, boxes and names of instances for MRPT's SceneViewer3D"};
    apps::Text pngDir{*this, "--png-dir", "DIR",
                      "Folder for pictures with legends: instances, categories and three "
                      "uncertainties, each from the top and in perspective"};
    apps::Text csv{*this, "--csv", "FILE", "Table of the instances"};
    apps::Text json{*this, "--json", "FILE",
                    "Instances with evidence, probabilities, entropies and boxes"};
    apps::Text perInstance{*this, "--per-instance", "DIR", "Folder for a PLY of each instance"};
    apps::Text ply{
        *this, "--ply", "FILE",
        "Voxels as a binary point cloud with instance, category, occupancy and uncertainties"};
    apps::Text map{*this, "-m,--map", "MAP.voxeland", "Map to read", apps::Presence::required};
};

/** Tries to write one format after another: what one of them cannot hold, or cannot be written,
 * keeps none of the others from being written. */
class Attempts
{
 public:
    void attempt(const std::function<void()>& write)
    {
        try {
            write();
        } catch (const ConfigurationError& e) {
            m_refusals.emplace_back(e.what());
        } catch (const OutputError& e) {
            m_failures.emplace_back(e.what());
        }
    }
    /** Those completed; each is told on stdout. */
    [[nodiscard]] WrittenFiles& written() { return m_written; }
    /** \throws OutputError that tells what failed first and what is complete, if anything failed,
     *  ConfigurationError that tells what was refused, if anything was */
    void finish() const
    {
        if (!m_failures.empty()) throw OutputError(m_failures.front() + m_written.told());
        if (!m_refusals.empty()) throw ConfigurationError(joined(m_refusals, "; "));
    }

 private:
    std::vector<std::string> m_refusals, m_failures;
    WrittenFiles m_written{[](const std::string& file) {
        std::cout << "written: " << printable(file, UNCUT) << "\n";
    }};
};

/** Heights asked for, or else these, in the gravity-aligned frame. Says on stderr where they are.
 */
HeightRange heightsOf(Arguments& arguments, const SemanticVoxelMap& map,
                      const GravityAlignedFrame& frame, HeightRange heights)
{
    if (arguments.height.isSet()) heights = apps::parseHeights(arguments.height);
    const double floor = floorHeight(map, frame);
    const auto& up = frame.axes()[2];
    arguments.note(format("heights are along (%.3f, %.3f, %.3f), from %.2f m", up.x, up.y, up.z,
                          floor + map.origin().z));
    return {floor + heights.low, floor + heights.high};
}

void writePly(Arguments& arguments, const SemanticVoxelMap& map, WrittenFiles& written)
{
    const bool occupiedOnly = !arguments.all.isSet();
    if (arguments.ply.isSet()) {
        exportPly(map, arguments.ply.value(), occupiedOnly);
        written.add(arguments.ply.value());
    }
    if (arguments.perInstance.isSet())
        exportPlyPerInstance(map, arguments.perInstance.value(), written, occupiedOnly);
}

void writeGrids(Arguments& arguments, const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                Attempts& attempts)
{
    if (!arguments.gridmap.isSet() && !arguments.rosMap.isSet()) return;
    const HeightSlice slice =
        inWorld(sliceOf(map, frame, heightsOf(arguments, map, frame, {0.1, 1.8})), map);
    if (arguments.gridmap.isSet())
        attempts.attempt([&] {
            exportGridmap(slice, arguments.gridmap.value());
            attempts.written().add(arguments.gridmap.value());
        });
    if (arguments.rosMap.isSet())
        attempts.attempt(
            [&] { exportRosMap(slice, arguments.rosMap.value(), attempts.written()); });
}

/** Whether any object is of a category, or that is *unknown*. */
bool isInMap(const SemanticVoxelMap& map, const std::string& name)
{
    const auto fits = [&](const std::string& category) {
        return nameFit(name, category) >= NameFit::plural;
    };
    const auto instances = summarizeInstances(map);
    return fits(UNKNOWN_CATEGORY) ||
           std::any_of(instances.begin(), instances.end(),
                       [&](const InstanceSummary& s) { return fits(s.category()); });
}

void writePoints(Arguments& arguments, const SemanticVoxelMap& map,
                 const GravityAlignedFrame& frame, WrittenFiles& written)
{
    PointsFilter filter;
    filter.frame = frame;
    for (const std::string& name : arguments.category.values()) filter.categories.insert(name);
    for (const std::string& name : arguments.except.values()) filter.except.insert(name);
    for (const auto* names : {&filter.categories, &filter.except})
        for (const std::string& name : *names)
            if (!isInMap(map, name)) arguments.warn(whyNoneIsFound(map, name));
    if (arguments.height.isSet()) filter.heights = heightsOf(arguments, map, frame, {});
    if (exportPoints(map, filter, arguments.points.value()) == 0)
        arguments.warn("no voxel is of these categories and heights");
    written.add(arguments.points.value());
}

/** An output that is one file. */
void writeFile(const apps::Text& output, Attempts& attempts,
               const std::function<void(const std::string&)>& write)
{
    if (!output.isSet()) return;
    attempts.attempt([&] {
        write(output.value());
        attempts.written().add(output.value());
    });
}

void writeAll(Arguments& arguments, const SemanticVoxelMap& map, const GravityAlignedFrame& frame)
{
    Attempts attempts;
    attempts.attempt([&] { writePly(arguments, map, attempts.written()); });
    writeFile(arguments.json, attempts,
              [&](const std::string& file) { exportJson(map, frame, file); });
    writeFile(arguments.csv, attempts,
              [&](const std::string& file) { exportCsv(map, frame, file); });
    writeFile(arguments.glb, attempts,
              [&](const std::string& file) { exportGlb(map, frame, file); });
    writeFile(arguments.scene, attempts,
              [&](const std::string& file) { exportScene(map, frame, file); });
    writeFile(arguments.octomap, attempts,
              [&](const std::string& file) { exportOctoMap(map, file); });
    attempts.attempt([&] { writeGrids(arguments, map, frame, attempts); });
    if (arguments.points.isSet())
        attempts.attempt([&] { writePoints(arguments, map, frame, attempts.written()); });
    if (arguments.pngDir.isSet())
        attempts.attempt([&] {
            ViewOptions views;
            views.up = frame.axes()[2];
            exportViews(map, arguments.pngDir.value(), attempts.written(), views);
        });
    attempts.finish();
}

/** Complains about a file named like one of another format; any other name will do. Where the
 * ending chooses among formats, the exporter looks at it itself. */
void checkEndings(Arguments& arguments)
{
    using mrpt::system::strCmpI;
    for (const auto& [output, ending] :
         {std::pair(&arguments.ply, ".ply"), std::pair(&arguments.json, ".json"),
          std::pair(&arguments.csv, ".csv"), std::pair(&arguments.glb, ".glb"),
          std::pair(&arguments.scene, ".3Dscene"), std::pair(&arguments.gridmap, ".gridmap")})
    {
        const std::string own = std::filesystem::path(output->value()).extension().string();
        const bool isKnown = std::any_of(std::begin(ENDINGS), std::end(ENDINGS),
                                         [&](const char* known) { return strCmpI(own, known); });
        if (isKnown && !strCmpI(own, ending))
            throw ConfigurationError(output->name() + " '" + output->value() + "' must end in " +
                                     ending + ", which is what it writes");
    }
}

/** Complains about wrong usage before a map is read. */
void check(Arguments& arguments)
{
    checkEndings(arguments);
    std::vector<std::string> outputs;
    for (auto* output :
         {&arguments.ply, &arguments.json, &arguments.csv, &arguments.glb, &arguments.scene,
          &arguments.octomap, &arguments.gridmap, &arguments.rosMap, &arguments.points})
        outputs.push_back(output->value());
    const auto isEmpty = [](const std::string& file) { return file.empty(); };
    if (std::all_of(outputs.begin(), outputs.end(), isEmpty) && !arguments.perInstance.isSet() &&
        !arguments.pngDir.isSet())
        throw ConfigurationError("nothing to write: name at least one output (see --help)");
    if (arguments.rosMap.isSet()) outputs.push_back(rosImageOf(arguments.rosMap.value()));
    if ((arguments.category.isSet() || arguments.except.isSet()) && !arguments.points.isSet())
        throw ConfigurationError("--category and --except go with --points");
    if (arguments.height.isSet()) {
        static_cast<void>(apps::parseHeights(arguments.height));
        if (!arguments.points.isSet() && !arguments.gridmap.isSet() && !arguments.rosMap.isSet())
            throw ConfigurationError("--height goes with --points, --gridmap and --ros-map");
    }
    for (auto* folder : {&arguments.perInstance, &arguments.pngDir})
        if (folder->isSet()) makeOutputFolder(folder->value());
    apps::checkOutputs(outputs, {arguments.map.value()});
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    std::optional<mrpt::math::TVector3D> up;
    if (arguments.up.isSet()) up = apps::parseDirection(arguments.up);
    check(arguments);

    const auto loaded = loadMap(arguments.map.value());
    if (arguments.minVoxels.isSet())
        deactivateSmallInstances(loaded->editMap(), arguments.minVoxels.value());
    const SemanticVoxelMap& map = loaded->map();
    writeAll(arguments, map, GravityAlignedFrame(up ? *up : estimateUp(map)));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-export", [&] { return run(argc, argv); });
}
