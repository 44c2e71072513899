// SPDX-License-Identifier: BSD-3-Clause
/** Says how good maps are, and how well they know it, given ground truth. */
#include "common/CommandLine.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
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

    apps::Text reliabilityPng{*this, "--reliability-png", "FILE",
                              "Write a picture of the share that is right against probability"};
    apps::Text reliability{*this, "--reliability", "FILE",
                           "Write the share that is right against probability as CSV"};
    apps::Text curvePng{*this, "--curve-png", "FILE",
                        "Write a picture of precision against entropy"};
    apps::Text curve{*this, "--curve", "FILE", "Write precision against entropy threshold as CSV"};
    apps::Text report{*this, "--report", "FILE", "Write all figures as JSON"};
    apps::Number<double> radius{*this, "--match-radius", "METRES",
                                "Reach of an occupied voxel's centre for points that no occupied "
                                "voxel contains [m] (default: max(0.05, half a voxel's diagonal))",
                                0};
    apps::Number<size_t> minPoints{
        *this, "--min-points", "N",
        "Instances with fewer ground-truth points are left out, objects ignored (default: 100)",
        EvaluationProtocol().minPoints};
    apps::Text voidPolicy{*this, "--void", "ignore|fp",
                          "Instances on nothing annotated with an evaluated class: ignore "
                          "(default) or false positives",
                          "ignore"};
    apps::Text score{*this, "--score", "probability|certainty|observations",
                     "What ranks instances: probability of the category (default), certainty (1 - "
                     "entropy / ln(number of categories)), or number of observations",
                     "probability"};
    apps::Text labels{*this, "--labels", "FILE",
                      "CSV file (header name,class) of the category names to evaluate and their "
                      "classes (default: the nine classes of the paper)"};
    apps::Text format{*this, "--format", joined(groundTruthFormats(), "|"),
                      "Format of the ground truth (default: ply)", "ply"};
    apps::Texts truths{*this, "--gt", "DIR", "Ground truth; once for each map, in order",
                       apps::Presence::required};
    apps::Texts maps{*this, "-m,--map", "FILE", "Map file (*.voxeland); may be given repeatedly",
                     apps::Presence::required};
};

void checkArguments(Arguments& arguments)
{
    const size_t maps = arguments.maps.values().size();
    const size_t truths = arguments.truths.values().size();
    if (maps != truths)
        throw ConfigurationError("there are " + std::to_string(maps) + " -m but " +
                                 std::to_string(truths) +
                                 " --gt: give one ground truth for each map");
    if (arguments.radius.value() < 0)
        throw ConfigurationError("--match-radius must not be negative");
    std::vector<std::string> inputs = arguments.maps.values();
    inputs.push_back(arguments.labels.value());
    apps::checkOutputs(
        {{arguments.report.value(), arguments.curve.value(), arguments.curvePng.value(),
          arguments.reliability.value(), arguments.reliabilityPng.value()},
         {},
         {}},
        {inputs, {}, arguments.truths.values()});
}

EvaluationProtocol protocolOf(Arguments& arguments)
{
    EvaluationProtocol protocol;
    protocol.minPoints = arguments.minPoints.value();
    protocol.voidPolicy = voidPolicyFromString(arguments.voidPolicy.value());
    protocol.score = scoreKindFromString(arguments.score.value());
    protocol.matchRadius = arguments.radius.value();
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
    const LabelMap classes = arguments.labels.isSet() ? LabelMap::fromFile(arguments.labels.value())
                                                      : LabelMap::paper9();
    EvaluationReport result(classes, protocol);
    for (size_t i = 0; i < arguments.maps.values().size(); ++i) {
        const std::string& mapFile = arguments.maps.values()[i];
        const std::string& truthFile = arguments.truths.values()[i];
        arguments.note("evaluating " + mapFile);
        const GroundTruth truth = readGroundTruth(truthFile, arguments.format.value());
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
    write(arguments.report.value(), result.json());
    const UncertaintyMetrics uncertainty = result.pooled().uncertainty;
    write(arguments.curve.value(), precisionCurveCsv(uncertainty.curve));
    write(arguments.reliability.value(), reliabilityCsv(uncertainty));
    write(arguments.reliabilityPng.value(), reliabilityPng(uncertainty));
    write(arguments.curvePng.value(), precisionCurvePng(uncertainty.curve, uncertainty.threshold));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-eval", [&] { return run(argc, argv); });
}
