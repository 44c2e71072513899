// SPDX-License-Identifier: BSD-3-Clause
/** Adds a detector's predictions to a rawlog. */
#include "common/CommandLine.h"
#include "common/Interruption.h"
#include "common/Progress.h"
#include "common/SetArgument.h"
#include "common/TrustPathsArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "datasets/RawlogPredictions.h"
#include "datasets/UnfinishedPredictions.h"
#include "rawlogs/ImagePaths.h"
#include "rawlogs/RawlogFiles.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"
#include "voxeland/observations/UnusableFrame.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <filesystem>
#include <iostream>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
const char* const DESCRIPTION = R"(Adds a detector's predictions to a rawlog with RGB-D frames.

  rawlog-add-instances -i k.rawlog --coco results.json -o k.rawlog
  rawlog-add-instances -i k.rawlog --coco results.json --categories cats.json -o k2.rawlog
  rawlog-add-instances -i k.rawlog --coco results.json --embed -o embedded.rawlog
  rawlog-add-instances -i k.rawlog --dnn yolov8.ini -o k.rawlog

They come from a file, or from a network that looks at the colour images (--dnn). image_id is the
name of a frame's image or of one that the file lists, else it counts the RGB-D frames from 0. The
predictions go to the file NAME.instances.rawlog beside the output NAME.rawlog, which is a copy of
the input unless both are the same; its external images are found through a link.
With --embed they go into the output, which then needs programs that load libvoxeland. A run with
--dnn that was stopped (Ctrl-C) or killed leaves what the network said so far in
NAME.instances.rawlog.unfinished; the same command goes on from there.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Text label{*this, "--sensor-label", "LABEL",
                     "Which sensor's RGB-D frames, where there are several's"};
    apps::Switch embed{*this, "--embed", "Put the predictions into the rawlog"};
    apps::TrustPathsArgument trustPaths{*this};
    apps::Switch strict{*this, "--strict",
                        "What is odd is an error, instead of left out and counted"};
    apps::SetArgument set{*this, "network's INI"};
    apps::Text categories{*this, "--categories", "FILE",
                          "Names of the categories the predictions give numbers of: JSON as COCO "
                          "has, CSV lines 'id,name', names alone, or data.yaml (default: COCO's)"};
    apps::Text dnn{*this, "--dnn", "FILE.ini",
                   "Configuration whose [converter] is a network to make the predictions with"};
    apps::Text coco{*this, "--coco", "RESULTS.json", "Predictions in the COCO results format"};
    apps::Text output{*this, "-o,--output", "OUT.rawlog", "Rawlog to write; may be the input",
                      apps::Presence::required};
    apps::Text input{*this, "-i,--input", "IN.rawlog", "Rawlog to read", apps::Presence::required};
};

void check(const Arguments& arguments)
{
    if (arguments.coco.isSet() == arguments.dnn.isSet())
        throw ConfigurationError("give predictions with --coco, or a network with --dnn");
    if (arguments.dnn.isSet() && arguments.categories.isSet())
        throw ConfigurationError("--categories goes with --coco; networks have [converter] labels");
    if (arguments.coco.isSet() && arguments.set.isSet())
        throw ConfigurationError("--set goes with --dnn");
    apps::checkOutputs(
        {{}, {arguments.output.value()}, {}},
        {{arguments.coco.value(), arguments.categories.value(), arguments.dnn.value()},
         {arguments.input.value()},
         {}});
}

/** A file and when it was written; its name alone if it is none. */
std::string stateOf(const std::string& file)
{
    std::error_code error;
    const auto size = fs::file_size(file, error);
    const auto written = fs::last_write_time(file, error).time_since_epoch().count();
    return file + (error ? "" : " " + std::to_string(size) + " " + std::to_string(written)) + "\n";
}

/** What makes predictions. */
struct Network
{
    std::shared_ptr<const COpinionConverter> converter;
    std::string origin;  //!< what its predictions depend on
};

/** The converter of the INI, which must be one that makes predictions. */
Network networkOf(Arguments& arguments)
{
    Ini ini = Ini::fromFile(arguments.dnn.value());
    arguments.set.applyTo(ini);
    const MapperConfig config(ini);
    const auto& converter = config.converter;
    if (!converter->makesPredictions())
        throw ConfigurationError("[converter] of '" + arguments.dnn.value() +
                                 "' makes no predictions: name a class that does, such as "
                                 "CDnnConverter");
    return {converter, config.reproducibleText() + stateOf(ini.value("converter", "model"))};
}

using ProgressOfFrames = std::function<void(size_t frames, double share)>;

/** The network's predictions. What it said before it was stopped is kept beside the output. */
AddedPredictions addSeen(Arguments& arguments, const AddPredictionsOptions& options,
                         const ProgressOfFrames& progress)
{
    const std::string &in = arguments.input.value(), &out = arguments.output.value();
    const Network network = networkOf(arguments);
    UnfinishedPredictions kept(RawlogFiles(out).sidecar.string() + ".unfinished",
                               network.origin + stateOf(in) + options.sensorLabel);
    if (kept.frames() > 0)
        arguments.note("going on after " + counted(kept.frames(), "frame") + " of an earlier run");
    LeftOut leftOut(arguments.strict.isSet());
    const PredictionSource look =
        [&](size_t, const mrpt::obs::CObservation3DRangeScan& scan) -> CObservationInstances::Ptr {
        checkImagePaths(scan, in, arguments.trustPaths.isSet());
        try {
            return network.converter->predict(scan);
        } catch (const UnusableFrame& e) {
            leftOut.add(e.what());
            return nullptr;
        }
    };
    const PredictionSource seen = [&](size_t frame,
                                      const mrpt::obs::CObservation3DRangeScan& scan) {
        return kept.of(frame, scan, look);
    };
    const apps::Interruption interruption;
    const auto added = addPredictions(in, seen, out, options, [&](size_t frames, double share) {
        progress(frames, share);
        if (interruption.wasRequested())
            throw apps::Interrupted(
                "stopped; what the network said is kept: the same command goes on from there");
    });
    if (leftOut.count() == added.frames) throw InputError(leftOut.first());
    kept.discard();
    if (leftOut.count() > 0) arguments.warn(leftOut.told("frame"));
    return added;
}

AddedPredictions add(Arguments& arguments)
{
    AddPredictionsOptions options;
    options.embed = arguments.embed.isSet();
    options.sensorLabel = arguments.label.value();
    const std::string &in = arguments.input.value(), &out = arguments.output.value();
    apps::Progress bar("frames", 0, !arguments.quiet());
    const auto progress = [&](size_t frames, double share) { bar.update(frames, share); };
    if (arguments.coco.isSet()) {
        const CocoPredictions recorded(arguments.coco.value(),
                                       arguments.categories.isSet()
                                           ? readCategoryNames(arguments.categories.value())
                                           : CategoryNames(),
                                       arguments.strict.isSet());
        MatchedPredictions matched(recorded, rgbdFramesOf(in, options.sensorLabel));
        const auto added = addPredictions(in, recordedPredictions(matched), out, options, progress);
        for (const std::string& note : matched.notes()) arguments.note(note);
        for (const std::string& warning : matched.warnings()) arguments.warn(warning);
        return added;
    }
    return addSeen(arguments, options, progress);
}

void printSummary(const AddedPredictions& added, Arguments& arguments)
{
    const RawlogFiles files(arguments.output.value());
    std::cout << "frames: " << added.frames << "\npredictions: " << added.predictions;
    std::cout << "\n";
    if (added.replaced > 0)
        std::cout << "replaced: predictions of " << counted(added.replaced, "frame") << "\n";
    if (added.rawlogWritten)
        std::cout << "written: " << printable(files.rawlog.string(), UNCUT) << "\n";
    if (!arguments.embed.isSet())
        std::cout << "written: " << printable(files.sidecar.string(), UNCUT) << "\n";
    if (added.imagesLinked)
        std::cout << "linked: " << printable(files.images.string(), UNCUT) << ", to the images of "
                  << printable(arguments.input.value(), UNCUT) << "\n";
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    check(arguments);
    printSummary(add(arguments), arguments);
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("rawlog-add-instances", [&] { return run(argc, argv); });
}
