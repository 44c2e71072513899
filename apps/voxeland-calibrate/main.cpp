// SPDX-License-Identifier: BSD-3-Clause
/** Learns from annotated maps what a detector's words mean, and applies it to maps. */
#include "common/CommandLine.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "evaluation/InstanceVerdicts.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/evaluation/CalibrationLearning.h"
#include "voxeland/evaluation/Comparison.h"
#include "voxeland/evaluation/UncertaintyMeasures.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Learns from annotated maps what a detector's words mean, so that probabilities are right.

  voxeland-calibrate -m a.voxeland --gt a_gt -m b.voxeland --gt b_gt -m c.voxeland --gt c_gt -o detector.ini
  rawlog2voxeland -i flat.rawlog -o flat.voxeland -c detector.ini
  voxeland-calibrate --apply detector.ini -m old.voxeland -o calibrated.voxeland
  voxeland-calibrate --undo -m calibrated.voxeland -o old.voxeland

How often is what the detector calls a chair one, and what is it otherwise? That is learnt as a table,
detector.csv beside detector.ini, with a probability for each category and for "unknown", which is
what the detector has no word for. Both are text: look at them, and change what you know better. Maps
of several scenes are needed; figures are cross-validated, each map being judged by what the others
taught. A map holds what it was calibrated with, and its opinions as they were: --undo brings it back.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Switch undo{*this, "--undo", "Write the map as it was before it was calibrated"};
    apps::Text apply{*this, "--apply", "FILE.ini", "Write the map calibrated with this"};
    apps::Text labels{*this, "--labels", "FILE",
                      "CSV file (header name,class) that says which names are one class (default: "
                      "the nine classes of the paper); others must be the same word"};
    apps::Text format{*this, "--format", joined(groundTruthFormats(), "|"),
                      "Format of the ground truth (default: ply)", "ply"};
    apps::Texts truths{*this, "--gt", "DIR", "Ground truth; once for each map, in order"};
    apps::Texts maps{*this, "-m,--map", "FILE", "Map file (*.voxeland); may be given repeatedly",
                     apps::Presence::required};
    apps::Text output{*this, "-o,--output", "FILE", "INI, or map, to write",
                      apps::Presence::required};
};

/** A map beside its ground truth. */
struct AnnotatedMap
{
    std::shared_ptr<CVoxelandMap> map;
    GroundTruth truth;
    std::string name;
};

/** How good the names of instances are, and their probabilities. */
struct Judgement
{
    std::vector<ConfidentDecision> confident;
    std::vector<UncertainDecision> uncertain;

    void add(const EvaluatedScene& scene, const EvaluationProtocol& protocol)
    {
        for (const InstanceVerdict& v : categoryVerdicts({scene}, protocol)) {
            confident.push_back({v.probability, v.correct});
            uncertain.push_back({v.entropy, !v.correct});
        }
    }
    [[nodiscard]] double rightShare() const
    {
        const auto right = std::count_if(confident.begin(), confident.end(),
                                         [](const ConfidentDecision& d) { return d.correct; });
        return static_cast<double>(right) / static_cast<double>(confident.size());
    }
};

void printFigures(const Judgement& before, const Judgement& after)
{
    const auto row = [](const char* name, double a, double b) {
        std::printf("  %-34s %7.3f %7.3f\n", name, a, b);
    };
    std::printf("cross-validated over maps              before   after\n");
    row("share of right names", before.rightShare(), after.rightShare());
    row("expected calibration error", expectedCalibrationError(before.confident),
        expectedCalibrationError(after.confident));
    row("... with bins of equal mass", equalMassCalibrationError(before.confident),
        equalMassCalibrationError(after.confident));
    row("... that chance alone would give", calibrationErrorByChance(before.confident),
        calibrationErrorByChance(after.confident));
    row("Brier score", brierScore(before.confident), brierScore(after.confident));
    row("negative log-likelihood [nat]", negativeLogLikelihood(before.confident),
        negativeLogLikelihood(after.confident));
    row("AUROC of entropy", areaUnderRoc(before.uncertain), areaUnderRoc(after.uncertain));
}

/** What each word means, if it is not itself in nearly all cases. */
void printMeanings(const Calibration& calibration)
{
    std::printf("%-20s %8s  otherwise mostly\n", "word", "right");
    for (const auto& [word, meaning] : calibration.meanings()) {
        if (word == Calibration::ANY) continue;
        const std::pair<const std::string, double>* other = nullptr;
        for (const auto& entry : meaning)
            if (entry.first != word && (other == nullptr || entry.second > other->second))
                other = &entry;
        const auto own = meaning.find(word);
        std::printf("  %-18s %8.2f  %s\n", printable(word).c_str(),
                    own == meaning.end() ? 0 : own->second,
                    other == nullptr
                        ? ""
                        : (printable(other->first) + " " + fixedText(other->second, 2)).c_str());
    }
}

std::vector<AnnotatedMap> readMaps(Arguments& arguments)
{
    std::vector<AnnotatedMap> maps;
    for (size_t i = 0; i < arguments.maps.values().size(); ++i) {
        const std::string& file = arguments.maps.values()[i];
        arguments.note("reading " + file);
        maps.push_back({loadMap(file),
                        readGroundTruth(arguments.truths.values()[i], arguments.format.value()),
                        std::filesystem::path(file).stem().string()});
        maps.back().map->editMap().setCalibration({});
    }
    return maps;
}

void writeCalibration(Arguments& arguments, const Calibration& calibration, size_t instances)
{
    const std::filesystem::path ini = arguments.output.value();
    std::filesystem::path table = ini;
    table.replace_extension(".csv");
    writeAtomically(table.string(), [&](std::ostream& out) { out << calibration.csv(); });
    writeAtomically(ini.string(), [&](std::ostream& out) {
        out << "# What a detector's words mean, learnt from " << counted(instances, "instance")
            << " of " << counted(arguments.maps.values().size(), "map")
            << ".\n[calibration]\nwords = " << table.filename().string()
            << "\nagreement = " << numberText(calibration.agreement()) << "\n";
    });
    std::printf("written: %s, %s\n", printable(ini.string(), UNCUT).c_str(),
                printable(table.string(), UNCUT).c_str());
}

int learn(Arguments& arguments)
{
    if (arguments.maps.values().size() != arguments.truths.values().size())
        throw ConfigurationError("give one --gt for each -m, or one of --apply and --undo");
    if (std::filesystem::path(arguments.output.value()).extension() != ".ini")
        throw ConfigurationError("name an INI with -o, such as detector.ini");
    const LabelMap labels = arguments.labels.isSet() ? LabelMap::fromFile(arguments.labels.value())
                                                     : LabelMap::paper9();
    const EvaluationProtocol protocol;
    std::vector<AnnotatedMap> maps = readMaps(arguments);
    std::vector<std::vector<CalibrationSample>> samples;
    Judgement before, after;
    size_t instances = 0;
    for (const AnnotatedMap& m : maps) {
        arguments.note("comparing " + m.name);
        const EvaluatedScene scene = compare(m.map->map(), m.truth, labels, protocol, m.name);
        samples.push_back(calibrationSamples(m.map->map(), scene, labels));
        instances += samples.back().size();
        before.add(scene, protocol);
    }
    const Calibration calibration = learnCalibration(samples);
    std::printf("learnt from %s of %s\n", counted(instances, "instance").c_str(),
                counted(maps.size(), "map").c_str());
    if (maps.size() > 2) {
        for (size_t i = 0; i < maps.size(); ++i) {
            auto others = samples;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            SemanticVoxelMap& map = maps[i].map->editMap();
            map.setCalibration(learnCalibration(others));
            after.add(compare(map, maps[i].truth, labels, protocol, maps[i].name), protocol);
        }
        printFigures(before, after);
    } else {
        arguments.warn("with fewer than three maps nothing is cross-validated: give more");
    }
    printMeanings(calibration);
    writeCalibration(arguments, calibration, instances);
    return 0;
}

/** Writes the one map with another calibration. */
int change(Arguments& arguments, const Calibration& calibration)
{
    if (arguments.maps.values().size() != 1 || !arguments.truths.values().empty())
        throw ConfigurationError("--apply and --undo take one -m, and no --gt");
    const auto map = loadMap(arguments.maps.values().front());
    map->editMap().setCalibration(calibration);
    saveMap(*map, arguments.output.value());
    return 0;
}

Calibration calibrationOf(const std::string& ini)
{
    const auto calibration =
        MapperConfig(Ini::fromFile(ini), MapperConfig::Purpose::asking).calibration;
    if (!calibration)
        throw ConfigurationError("'" + ini +
                                 "' names no table of words: it needs [calibration] words");
    return *calibration;
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    std::vector<std::string> inputs = arguments.maps.values();
    inputs.insert(inputs.end(), {arguments.apply.value(), arguments.labels.value()});
    const bool changes = arguments.apply.isSet() || arguments.undo.isSet();
    std::vector<std::string> outputs = {arguments.output.value()};
    if (!changes)
        outputs.push_back(
            std::filesystem::path(arguments.output.value()).replace_extension(".csv").string());
    apps::checkOutputs({outputs, {}, {}}, {inputs, {}, arguments.truths.values()});
    if (arguments.apply.isSet() && arguments.undo.isSet())
        throw ConfigurationError("give one of --apply and --undo");
    if (!changes) return learn(arguments);
    return change(arguments,
                  arguments.undo.isSet() ? Calibration() : calibrationOf(arguments.apply.value()));
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-calibrate", [&] { return run(argc, argv); });
}
