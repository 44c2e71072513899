// SPDX-License-Identifier: BSD-3-Clause
/** Writes a map in formats that other programs read. */
#include "base/ClassicNumbers.h"
#include "common/CommandLine.h"
#include "common/PointArgument.h"
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

    TCLAP::ValueArg<std::string> up{
        "",
        "up",
        "Direction of up in the map's frame (default: +z, or that direction near it in which floor"
        " and tables are level, or -y in a world with a camera's axes)",
        false,
        "",
        "X,Y,Z",
        parser()};
    TCLAP::ValueArg<std::string> height{
        "",
        "height",
        "Heights above the floor [m] of --gridmap and --ros-map (default: 0.1,1.8) and --points"
        " (default: all)",
        false,
        "",
        "LOW,HIGH",
        parser()};
    TCLAP::MultiArg<std::string> category{
        "",    "category", "--points: only of this category; may be repeated",
        false, "NAME",     parser()};
    TCLAP::MultiArg<std::string> except{
        "", "except", "--points: not of this category; may be repeated", false, "NAME", parser()};
    TCLAP::ValueArg<uint32_t> minVoxels{
        "",
        "min-voxels",
        "Take instances of fewer occupied voxels for unknown, in all outputs",
        false,
        0,
        "N",
        parser()};
    TCLAP::SwitchArg all{
        "", "all", "PLY: also voxels that were measured once but are now believed free", parser()};
    TCLAP::ValueArg<std::string> points{
        "",      "points", "Centres of voxels as an MRPT points map (.txt, .metricmap or .3Dscene)",
        false,   "",       "FILE",
        parser()};
    TCLAP::ValueArg<std::string> rosMap{
        "",      "ros-map", "Slice of some heights for ROS's map_server, with a .pgm beside it",
        false,   "",        "FILE.yaml",
        parser()};
    TCLAP::ValueArg<std::string> gridmap{
        "",      "gridmap", "Slice of some heights as an MRPT occupancy grid",
        false,   "",        "FILE.gridmap",
        parser()};
    TCLAP::ValueArg<std::string> octomap{
        "",        "octomap", "Occupancy as an OctoMap (.bt, or .ot with probabilities)", false, "",
        "FILE.bt", parser()};
    TCLAP::ValueArg<std::string> glb{
        "",      "glb", "Binary glTF: voxels as a coloured mesh, a node for each instance",
        false,   "",    "FILE.glb",
        parser()};
    TCLAP::ValueArg<std::string> scene{
        "",      "scene", "Voxels, boxes and names of instances for MRPT's SceneViewer3D",
        false,   "",      "FILE.3Dscene",
        parser()};
    TCLAP::ValueArg<std::string> pngDir{
        "",
        "png-dir",
        "Folder for pictures with legends: instances, categories and three uncertainties, each"
        " from the top and in perspective",
        false,
        "",
        "DIR",
        parser()};
    TCLAP::ValueArg<std::string> csv{"",     "csv",   "Table of the instances", false, "",
                                     "FILE", parser()};
    TCLAP::ValueArg<std::string> json{
        "",     "json",  "Instances with evidence, probabilities, entropies and boxes", false, "",
        "FILE", parser()};
    TCLAP::ValueArg<std::string> perInstance{
        "", "per-instance", "Folder for a PLY of each instance", false, "", "DIR", parser()};
    TCLAP::ValueArg<std::string> ply{
        "",
        "ply",
        "Voxels as a binary point cloud with instance, category, occupancy and uncertainties",
        false,
        "",
        "FILE",
        parser()};
    TCLAP::ValueArg<std::string> map{"m", "map", "Map to read", true, "", "MAP.voxeland", parser()};
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
    if (arguments.height.isSet())
        heights = apps::parseHeights("height", arguments.height.getValue());
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
        exportPly(map, arguments.ply.getValue(), occupiedOnly);
        written.add(arguments.ply.getValue());
    }
    if (arguments.perInstance.isSet())
        exportPlyPerInstance(map, arguments.perInstance.getValue(), written, occupiedOnly);
}

void writeGrids(Arguments& arguments, const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                Attempts& attempts)
{
    if (!arguments.gridmap.isSet() && !arguments.rosMap.isSet()) return;
    const HeightSlice slice =
        inWorld(sliceOf(map, frame, heightsOf(arguments, map, frame, {0.1, 1.8})), map);
    if (arguments.gridmap.isSet())
        attempts.attempt([&] {
            exportGridmap(slice, arguments.gridmap.getValue());
            attempts.written().add(arguments.gridmap.getValue());
        });
    if (arguments.rosMap.isSet())
        attempts.attempt(
            [&] { exportRosMap(slice, arguments.rosMap.getValue(), attempts.written()); });
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
    for (const std::string& name : arguments.category.getValue()) filter.categories.insert(name);
    for (const std::string& name : arguments.except.getValue()) filter.except.insert(name);
    for (const auto* names : {&filter.categories, &filter.except})
        for (const std::string& name : *names)
            if (!isInMap(map, name)) arguments.warn(whyNoneIsFound(map, name));
    if (arguments.height.isSet()) filter.heights = heightsOf(arguments, map, frame, {});
    if (exportPoints(map, filter, arguments.points.getValue()) == 0)
        arguments.warn("no voxel is of these categories and heights");
    written.add(arguments.points.getValue());
}

/** An output that is one file. */
void writeFile(TCLAP::ValueArg<std::string>& output, Attempts& attempts,
               const std::function<void(const std::string&)>& write)
{
    if (!output.isSet()) return;
    attempts.attempt([&] {
        write(output.getValue());
        attempts.written().add(output.getValue());
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
            exportViews(map, arguments.pngDir.getValue(), attempts.written(), views);
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
        const std::string own = std::filesystem::path(output->getValue()).extension().string();
        const bool isKnown = std::any_of(std::begin(ENDINGS), std::end(ENDINGS),
                                         [&](const char* known) { return strCmpI(own, known); });
        if (isKnown && !strCmpI(own, ending))
            throw ConfigurationError("--" + output->getName() + " '" + output->getValue() +
                                     "' must end in " + ending + ", which is what it writes");
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
        outputs.push_back(output->getValue());
    const auto isEmpty = [](const std::string& file) { return file.empty(); };
    if (std::all_of(outputs.begin(), outputs.end(), isEmpty) && !arguments.perInstance.isSet() &&
        !arguments.pngDir.isSet())
        throw ConfigurationError("nothing to write: name at least one output (see --help)");
    if (arguments.rosMap.isSet()) outputs.push_back(rosImageOf(arguments.rosMap.getValue()));
    if ((arguments.category.isSet() || arguments.except.isSet()) && !arguments.points.isSet())
        throw ConfigurationError("--category and --except go with --points");
    if (arguments.height.isSet()) {
        static_cast<void>(apps::parseHeights("height", arguments.height.getValue()));
        if (!arguments.points.isSet() && !arguments.gridmap.isSet() && !arguments.rosMap.isSet())
            throw ConfigurationError("--height goes with --points, --gridmap and --ros-map");
    }
    for (auto* folder : {&arguments.perInstance, &arguments.pngDir})
        if (folder->isSet()) makeOutputFolder(folder->getValue());
    apps::checkOutputs(outputs, {arguments.map.getValue()});
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    std::optional<mrpt::math::TVector3D> up;
    if (arguments.up.isSet()) up = apps::parseDirection("up", arguments.up.getValue());
    check(arguments);

    const auto loaded = loadMap(arguments.map.getValue());
    if (arguments.minVoxels.isSet())
        deactivateSmallInstances(loaded->editMap(), arguments.minVoxels.getValue());
    const SemanticVoxelMap& map = loaded->map();
    writeAll(arguments, map, GravityAlignedFrame(up ? *up : estimateUp(map)));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-export", [&] { return run(argc, argv); });
}
