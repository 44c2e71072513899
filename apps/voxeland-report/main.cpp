// SPDX-License-Identifier: BSD-3-Clause
/** Writes a page that shows a map. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
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

    apps::Text three{*this, "--three", "DIR",
                     std::string("Folder of three.js (default: ") + THREE_FOLDER + ")",
                     THREE_FOLDER};
    apps::Text up{*this, "--up", "X,Y,Z",
                  "Direction of up in the map's frame (default: estimated, +z if in doubt)"};
    apps::Number<uint32_t> minVoxels{*this, "--min-voxels", "N",
                                     "Take instances of fewer occupied voxels for unknown", 0};
    apps::Text labels{*this, "--labels", "FILE",
                      "CSV file (header name,class) of the categories that --gt is about (default: "
                      "the nine classes of the paper)"};
    apps::Text format{*this, "--format", "NAME", "Format of --gt (default: ply)", "ply"};
    apps::Text truth{*this, "--gt", "DIR", "Ground truth, to say how good the map is"};
    apps::Text timing{*this, "--timing", "FILE.csv",
                      "Times per stage, as written by rawlog2voxeland --timing"};
    apps::Text title{*this, "--title", "TEXT", "Title (default: the map's file name)"};
    apps::Text output{*this, "-o,--output", "FILE.html", "Page to write", apps::Presence::required};
    apps::Text map{*this, "-m,--map", "MAP.voxeland", "Map to read", apps::Presence::required};
};

/** The figures of voxeland-eval. */
std::string evaluationOf(Arguments& arguments, const SemanticVoxelMap& map)
{
    if (!arguments.truth.isSet()) return {};
    const EvaluationProtocol protocol;
    const LabelMap classes = arguments.labels.isSet() ? LabelMap::fromFile(arguments.labels.value())
                                                      : LabelMap::paper9();
    const std::string name = std::filesystem::path(arguments.map.value()).stem().string();
    const GroundTruth truth = readGroundTruth(arguments.truth.value(), arguments.format.value());
    EvaluationReport report(classes, protocol);
    report.add({arguments.map.value(), arguments.truth.value(),
                matchRadius(protocol, map.resolution()), toString(map.options().entropy)},
               compare(map, truth, classes, protocol, name));
    return report.text();
}

std::string timingOf(Arguments& arguments)
{
    if (!arguments.timing.isSet()) return {};
    std::ostringstream text;
    TimingLog::fromCsv(arguments.timing.value()).printSummary(text);
    return text.str();
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    const std::string& output = arguments.output.value();
    apps::checkOutputs(
        {{output}, {}, {}},
        {{arguments.map.value(), arguments.timing.value(), arguments.labels.value()}, {}, {}});
    const ThreeLibrary three = ThreeLibrary::fromFolder(arguments.three.value());
    ReportOptions options;
    if (arguments.up.isSet()) options.up = apps::parseDirection(arguments.up);
    options.title = arguments.title.isSet()
                        ? arguments.title.value()
                        : std::filesystem::path(arguments.map.value()).stem().string();
    options.timing = timingOf(arguments);

    const auto loaded = loadMap(arguments.map.value());
    options.evaluation = evaluationOf(arguments, loaded->map());
    SemanticVoxelMap map = loaded->map();
    if (arguments.minVoxels.isSet()) deactivateSmallInstances(map, arguments.minVoxels.value());
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
