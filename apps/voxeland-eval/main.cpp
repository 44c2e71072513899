// SPDX-License-Identifier: BSD-3-Clause
/** Says how good maps are, and how well they know it, given ground truth. */
#include "common/CommandLine.h"
#include "evaluation/EvaluationReport.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/evaluation/Comparison.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <filesystem>
#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Compares maps with annotated ground truth: average precision by ScanNet's and VOC's rules, panoptic
quality, over- and under-segmentation, and how well the map's uncertainty tells right from wrong.

  voxeland-eval -m sim.voxeland --gt sim_gt
  voxeland-eval -m sim.voxeland --gt sim_gt --report sim.json --curve-png sim.png
  voxeland-eval -m a.voxeland --gt a_gt -m b.voxeland --gt b_gt --labels my_classes.csv --void fp
  voxeland-eval -m 011.voxeland --gt scenenn/011 --format scenenn
  voxeland-eval -m s.voxeland --gt scans/scene0027_00 --format scannet --labels scannet18.csv

Several maps are evaluated one by one, pooled (as ScanNet's benchmark does) and averaged (as the paper
does). Ground truth of the format ply is a folder with ground_truth.ply (or a PLY file) whose vertices
have x, y, z [m], instance (0: none, or structure) and category, and a categories.csv (header
index,name) beside it. scannet is a scene's folder with SCENE_vh_clean_2.ply, its segs.json and
aggregation.json, and scannetv2-labels.combined.tsv there or above; scenenn one with NNN.ply and
NNN.xml. The numbers go to stdout, with the protocol they depend on.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    TCLAP::ValueArg<std::string> curvePng{
        "",     "curve-png", "Write a picture of precision against entropy", false, "",
        "FILE", parser()};
    TCLAP::ValueArg<std::string> curve{
        "",     "curve", "Write precision against entropy threshold as CSV", false, "",
        "FILE", parser()};
    TCLAP::ValueArg<std::string> report{"",     "report", "Write all figures as JSON", false, "",
                                        "FILE", parser()};
    TCLAP::ValueArg<double> radius{
        "",
        "match-radius",
        "Reach of an occupied voxel's centre for points that no occupied "
        "voxel contains [m] (default: max(0.05, half a voxel's diagonal))",
        false,
        0,
        "METRES",
        parser()};
    TCLAP::ValueArg<size_t> minPoints{
        "",
        "min-points",
        "Instances with fewer ground-truth points are left out, objects ignored (default: 100)",
        false,
        EvaluationProtocol().minPoints,
        "N",
        parser()};
    TCLAP::ValueArg<std::string> voidPolicy{
        "",
        "void",
        "Instances on nothing annotated with an evaluated class: ignore (default) or false "
        "positives",
        false,
        "ignore",
        "ignore|fp",
        parser()};
    TCLAP::ValueArg<std::string> score{
        "",
        "score",
        "What ranks instances: probability of the category (default), certainty (1 - entropy / "
        "ln(number of categories)), or number of observations",
        false,
        "probability",
        "probability|certainty|observations",
        parser()};
    TCLAP::ValueArg<std::string> labels{
        "",
        "labels",
        "CSV file (header name,class) of the category names to evaluate and their classes "
        "(default: the nine classes of the paper)",
        false,
        "",
        "FILE",
        parser()};
    TCLAP::ValueArg<std::string> format{
        "",      "format", "Format of the ground truth (default: ply)",
        false,   "ply",    joined(groundTruthFormats(), "|"),
        parser()};
    TCLAP::MultiArg<std::string> truths{"",   "gt",  "Ground truth; once for each map, in order",
                                        true, "DIR", parser()};
    TCLAP::MultiArg<std::string> maps{
        "m", "map", "Map file (*.voxeland); may be given repeatedly", true, "FILE", parser()};
};

void checkArguments(Arguments& arguments)
{
    const size_t maps = arguments.maps.getValue().size();
    const size_t truths = arguments.truths.getValue().size();
    if (maps != truths)
        throw ConfigurationError("there are " + std::to_string(maps) + " -m but " +
                                 std::to_string(truths) +
                                 " --gt: give one ground truth for each map");
    if (arguments.radius.getValue() < 0)
        throw ConfigurationError("--match-radius must not be negative");
    std::vector<std::string> inputs = arguments.maps.getValue();
    inputs.push_back(arguments.labels.getValue());
    inputs.insert(inputs.end(), arguments.truths.getValue().begin(),
                  arguments.truths.getValue().end());
    apps::checkOutputs(
        {arguments.report.getValue(), arguments.curve.getValue(), arguments.curvePng.getValue()},
        inputs);
}

EvaluationProtocol protocolOf(Arguments& arguments)
{
    EvaluationProtocol protocol;
    protocol.minPoints = arguments.minPoints.getValue();
    protocol.voidPolicy = voidPolicyFromString(arguments.voidPolicy.getValue());
    protocol.score = scoreKindFromString(arguments.score.getValue());
    protocol.matchRadius = arguments.radius.getValue();
    return protocol;
}

/** Name of a scene: the map file's, without folder and extension. */
std::string sceneName(const std::string& mapFile)
{
    return std::filesystem::path(mapFile).stem().string();
}

void write(const std::string& file, const std::string& content)
{
    if (file.empty()) return;
    writeAtomically(file, [&](std::ostream& out) { out << content; });
}

/** Compares each map with its ground truth. */
EvaluationReport evaluateMaps(Arguments& arguments)
{
    const EvaluationProtocol protocol = protocolOf(arguments);
    const LabelMap classes = arguments.labels.isSet()
                                 ? LabelMap::fromFile(arguments.labels.getValue())
                                 : LabelMap::paper9();
    EvaluationReport result(classes, protocol);
    for (size_t i = 0; i < arguments.maps.getValue().size(); ++i) {
        const std::string& mapFile = arguments.maps.getValue()[i];
        const std::string& truthFile = arguments.truths.getValue()[i];
        arguments.note("evaluating " + mapFile);
        const GroundTruth truth = readGroundTruth(truthFile, arguments.format.getValue());
        const auto file = loadMap(mapFile);
        const SemanticVoxelMap& map = file->map();
        result.add({mapFile, truthFile, matchRadius(protocol, map.resolution()),
                    toString(map.options().entropy)},
                   compare(map, truth, classes, protocol, sceneName(mapFile)));
    }
    return result;
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    checkArguments(arguments);
    const EvaluationReport result = evaluateMaps(arguments);
    std::cout << result.text();
    write(arguments.report.getValue(), result.json());
    const UncertaintyMetrics uncertainty = result.pooled().uncertainty;
    write(arguments.curve.getValue(), precisionCurveCsv(uncertainty.curve));
    write(arguments.curvePng.getValue(),
          precisionCurvePng(uncertainty.curve, uncertainty.threshold));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-eval", [&] { return run(argc, argv); });
}
