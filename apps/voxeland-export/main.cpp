// SPDX-License-Identifier: BSD-3-Clause
/** Writes a map in formats that other programs read. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "voxeland/errors.h"
#include "voxeland/io/InstancesCsv.h"
#include "voxeland/io/InstancesJson.h"
#include "voxeland/io/MapPly.h"
#include "voxeland/io/MapViews.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION = R"(Writes a Voxeland map in formats that other programs read.

  voxeland-export -m kitchen.voxeland --png-dir pictures
  voxeland-export -m kitchen.voxeland --ply kitchen.ply --json kitchen.json --csv kitchen.csv

At least one output must be named. Existing files are replaced once the new ones are complete.
Coordinates are metres in the map's frame, entropies are in nat.)";

int run(int argc, char** argv)
{
    apps::CommandLine commandLine(DESCRIPTION);
    auto& parser = commandLine.parser();
    TCLAP::ValueArg<std::string> up(
        "", "up",
        "Direction of up for the pictures, in the map's frame (default: +z, or that direction near"
        " it in which floor and tables are level)",
        false, "", "X,Y,Z", parser);
    TCLAP::SwitchArg all(
        "", "all", "PLY: also voxels that were measured once but are now believed free", parser);
    TCLAP::ValueArg<std::string> pngDir(
        "", "png-dir",
        "Folder for pictures with legends: instances, categories and three uncertainties, each"
        " from the top and in perspective",
        false, "", "DIR", parser);
    TCLAP::ValueArg<std::string> csv("", "csv", "Table of the instances", false, "", "FILE",
                                     parser);
    TCLAP::ValueArg<std::string> json("", "json",
                                      "Instances with evidence, probabilities, entropies and boxes",
                                      false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> ply(
        "", "ply",
        "Voxels as a binary point cloud with instance, category, occupancy and uncertainties",
        false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> mapFile("m", "map", "Map to read", true, "", "MAP.voxeland",
                                         parser);
    if (!commandLine.parse(argc, argv)) return 0;
    if (!ply.isSet() && !json.isSet() && !csv.isSet() && !pngDir.isSet())
        throw ConfigurationError(
            "nothing to write: name at least one of --ply, --json, --csv and --png-dir");
    apps::checkOutputs({ply.getValue(), json.getValue(), csv.getValue()}, {mapFile.getValue()});
    ViewOptions views;
    if (up.isSet()) views.up = apps::parsePoint("up", up.getValue());

    const auto loaded = loadMap(mapFile.getValue());
    const SemanticVoxelMap& map = loaded->map();
    const auto written = [](const std::string& file) { std::cout << "written: " << file << "\n"; };
    if (ply.isSet()) {
        exportPly(map, ply.getValue(), !all.isSet());
        written(ply.getValue());
    }
    if (json.isSet()) {
        exportJson(map, json.getValue());
        written(json.getValue());
    }
    if (csv.isSet()) {
        exportCsv(map, csv.getValue());
        written(csv.getValue());
    }
    if (pngDir.isSet())
        for (const std::string& file : exportViews(map, pngDir.getValue(), views)) written(file);
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-export", [&] { return run(argc, argv); });
}
