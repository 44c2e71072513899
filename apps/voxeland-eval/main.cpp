// SPDX-License-Identifier: BSD-3-Clause
/** Says how good maps are, and how well they know it, given ground truth. */
#include "common/CommandLine.h"
#include "voxeland/errors.h"
#include "voxeland/evaluation/Comparison.h"
#include "voxeland/evaluation/EvaluationReport.h"
#include "voxeland/io/AtomicFile.h"
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

Several maps are evaluated one by one, pooled (as ScanNet's benchmark does) and averaged (as the paper
does). Ground truth of the format ply is a folder with ground_truth.ply (or a PLY file) whose vertices
have x, y, z [m], instance (0: none, or structure) and category, and a categories.csv (header
index,name) beside it. The numbers go to stdout, with the protocol they depend on.)";

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& w : words) text += (text.empty() ? "" : "|") + w;
    return text;
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

int run(int argc, char** argv)
{
    apps::CommandLine commandLine(DESCRIPTION);
    auto& parser = commandLine.parser();
    TCLAP::ValueArg<std::string> curvePng(
        "", "curve-png", "Write a picture of precision against entropy", false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> curve(
        "", "curve", "Write precision against entropy threshold as CSV", false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> report("", "report", "Write all figures as JSON", false, "",
                                        "FILE", parser);
    TCLAP::ValueArg<double> radius(
        "", "match-radius",
        "Reach of an occupied voxel's centre for points that no occupied "
        "voxel contains [m] (default: max(0.05, half a voxel's diagonal))",
        false, 0, "METRES", parser);
    TCLAP::ValueArg<size_t> minPoints(
        "", "min-points",
        "Instances with fewer ground-truth points are left out, objects ignored (default: 100)",
        false, EvaluationProtocol().minPoints, "N", parser);
    TCLAP::ValueArg<std::string> voidPolicy(
        "", "void",
        "Instances on nothing annotated with an evaluated class: ignore (default) or false "
        "positives",
        false, "ignore", "ignore|fp", parser);
    TCLAP::ValueArg<std::string> score(
        "", "score",
        "What ranks instances: probability of the category (default), certainty (1 - entropy / "
        "ln(number of categories)), or number of observations",
        false, "probability", "probability|certainty|observations", parser);
    TCLAP::ValueArg<std::string> labels(
        "", "labels",
        "CSV file (header name,class) of the category names to evaluate and their classes "
        "(default: the nine classes of the paper)",
        false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> format("", "format", "Format of the ground truth (default: ply)",
                                        false, "ply", joined(groundTruthFormats()), parser);
    TCLAP::MultiArg<std::string> truths("", "gt", "Ground truth; once for each map, in order", true,
                                        "DIR", parser);
    TCLAP::MultiArg<std::string> maps("m", "map", "Map file (*.voxeland); may be given repeatedly",
                                      true, "FILE", parser);
    if (!commandLine.parse(argc, argv)) return 0;

    const auto& mapFiles = maps.getValue();
    const auto& truthFiles = truths.getValue();
    if (mapFiles.size() != truthFiles.size())
        throw ConfigurationError("there are " + std::to_string(mapFiles.size()) + " -m but " +
                                 std::to_string(truthFiles.size()) +
                                 " --gt: give one ground truth for each map");
    if (radius.getValue() < 0) throw ConfigurationError("--match-radius must not be negative");
    EvaluationProtocol protocol;
    protocol.minPoints = minPoints.getValue();
    protocol.voidPolicy = voidPolicyFromString(voidPolicy.getValue());
    protocol.score = scoreKindFromString(score.getValue());
    protocol.matchRadius = radius.getValue();
    const LabelMap classes =
        labels.isSet() ? LabelMap::fromFile(labels.getValue()) : LabelMap::paper9();

    EvaluationReport result(classes, protocol);
    for (size_t i = 0; i < mapFiles.size(); ++i) {
        if (!commandLine.quiet()) std::cerr << "evaluating " << mapFiles[i] << "\n";
        const GroundTruth truth = readGroundTruth(truthFiles[i], format.getValue());
        const auto file = loadMap(mapFiles[i]);
        const SemanticVoxelMap& map = file->map();
        result.add({mapFiles[i], truthFiles[i], matchRadius(protocol, map.resolution()),
                    toString(map.options().entropy)},
                   compare(map, truth, classes, protocol, sceneName(mapFiles[i])));
    }
    std::cout << result.text();
    write(report.getValue(), result.json());
    const UncertaintyMetrics uncertainty = result.pooled().uncertainty;
    write(curve.getValue(), precisionCurveCsv(uncertainty.curve));
    write(curvePng.getValue(), precisionCurvePng(uncertainty.curve, uncertainty.threshold));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return voxeland::apps::runProgram("voxeland-eval", [&] { return run(argc, argv); });
}
