// SPDX-License-Identifier: BSD-3-Clause
/** Writes a page that shows a map. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "evaluation/EvaluationReport.h"
#include "pipeline/TimingLog.h"
#include "report/MapReport.h"
#include "voxeland/base/printable.h"
#include "voxeland/evaluation/Comparison.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/map/SmallInstances.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <filesystem>
#include <iostream>
#include <sstream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Writes a page that shows a Voxeland map: its voxels in 3D, to be turned and coloured by object,
category or uncertainty, its objects as a table, pictures and figures.

  voxeland-report -m kitchen.voxeland -o kitchen.html
  voxeland-report -m kitchen.voxeland -o kitchen.html --min-voxels 10 --title "Red kitchen"
  voxeland-report -m sim.voxeland --gt truth --timing sim.csv -o sim.html

It is one HTML file that needs no network. The 3D view is drawn by three.js, which is taken from Debian's
package libjs-three, or from --three, and put into the file.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    TCLAP::ValueArg<std::string> three{
        "",      "three",      std::string("Folder of three.js (default: ") + THREE_FOLDER + ")",
        false,   THREE_FOLDER, "DIR",
        parser()};
    TCLAP::ValueArg<std::string> up{
        "",      "up", "Direction of up in the map's frame (default: estimated, +z if in doubt)",
        false,   "",   "X,Y,Z",
        parser()};
    TCLAP::ValueArg<uint32_t> minVoxels{
        "",  "min-voxels", "Take instances of fewer occupied voxels for unknown", false, 0,
        "N", parser()};
    TCLAP::ValueArg<std::string> labels{
        "",
        "labels",
        "CSV file (header name,class) of the categories that --gt is about (default: the nine"
        " classes of the paper)",
        false,
        "",
        "FILE",
        parser()};
    TCLAP::ValueArg<std::string> format{
        "", "format", "Format of --gt (default: ply)", false, "ply", "NAME", parser()};
    TCLAP::ValueArg<std::string> truth{
        "", "gt", "Ground truth, to say how good the map is", false, "", "DIR", parser()};
    TCLAP::ValueArg<std::string> timing{
        "",         "timing", "Times per stage, as written by rawlog2voxeland --timing", false, "",
        "FILE.csv", parser()};
    TCLAP::ValueArg<std::string> title{
        "", "title", "Title (default: the map's file name)", false, "", "TEXT", parser()};
    TCLAP::ValueArg<std::string> output{"o", "output",    "Page to write", true,
                                        "",  "FILE.html", parser()};
    TCLAP::ValueArg<std::string> map{"m", "map", "Map to read", true, "", "MAP.voxeland", parser()};
};

/** The figures of voxeland-eval. */
std::string evaluationOf(Arguments& arguments, const SemanticVoxelMap& map)
{
    if (!arguments.truth.isSet()) return {};
    const EvaluationProtocol protocol;
    const LabelMap classes = arguments.labels.isSet()
                                 ? LabelMap::fromFile(arguments.labels.getValue())
                                 : LabelMap::paper9();
    const std::string name = std::filesystem::path(arguments.map.getValue()).stem().string();
    const GroundTruth truth =
        readGroundTruth(arguments.truth.getValue(), arguments.format.getValue());
    EvaluationReport report(classes, protocol);
    report.add({arguments.map.getValue(), arguments.truth.getValue(),
                matchRadius(protocol, map.resolution()), toString(map.options().entropy)},
               compare(map, truth, classes, protocol, name));
    return report.text();
}

std::string timingOf(Arguments& arguments)
{
    if (!arguments.timing.isSet()) return {};
    std::ostringstream text;
    TimingLog::fromCsv(arguments.timing.getValue()).printSummary(text);
    return text.str();
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    const std::string& output = arguments.output.getValue();
    apps::checkOutputs({output}, {arguments.map.getValue(), arguments.timing.getValue(),
                                  arguments.labels.getValue()});
    const ThreeLibrary three = ThreeLibrary::fromFolder(arguments.three.getValue());
    ReportOptions options;
    if (arguments.up.isSet()) options.up = apps::parseDirection("up", arguments.up.getValue());
    options.title = arguments.title.isSet()
                        ? arguments.title.getValue()
                        : std::filesystem::path(arguments.map.getValue()).stem().string();
    options.timing = timingOf(arguments);

    const auto loaded = loadMap(arguments.map.getValue());
    options.evaluation = evaluationOf(arguments, loaded->map());
    SemanticVoxelMap map = loaded->map();
    if (arguments.minVoxels.isSet()) deactivateSmallInstances(map, arguments.minVoxels.getValue());
    const std::string page = reportAsHtml(map, loaded->counts(), options, three);
    writeAtomically(output, [&](std::ostream& out) { out << page; });
    std::cout << "written: " << printable(output, UNCUT) << "\n";
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-report", [&] { return run(argc, argv); });
}
