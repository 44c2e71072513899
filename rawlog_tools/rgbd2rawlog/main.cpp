// SPDX-License-Identifier: BSD-3-Clause
/** Makes a rawlog from a public RGB-D dataset. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/Progress.h"
#include "common/TrustPathsArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "datasets/CalibrationCheck.h"
#include "datasets/DatasetImport.h"
#include "rawlogs/RawlogFiles.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <optional>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
const char* const DESCRIPTION =
    R"(Makes an MRPT rawlog from a public RGB-D dataset, with a detector's predictions if there are any.

  rgbd2rawlog --format 7scenes --input redkitchen --check
  rgbd2rawlog --format 7scenes --input redkitchen --predictions coco.json --output k.rawlog
  rgbd2rawlog --format tum --input rgbd_dataset_freiburg1_room --output room.rawlog
  rgbd2rawlog --format scannet --input scene0027_00 --predictions gt --output s.rawlog
  rgbd2rawlog --format scenenn --input 011 --every 2 --predictions coco.json --output 011.rawlog
  rgbd2rawlog --format replica --input Replica/office0 --output office0.rawlog

Beside k.rawlog, which any MRPT program reads, it writes the images to k_Images (--images embedded:
into the rawlog) and the predictions to k.instances.rawlog (--embed: into the rawlog, which then
needs programs that load libvoxeland). Frames with a missing or damaged file or without a valid pose
are left out and listed; --strict makes each an error. Intrinsics of images that were resized since
are scaled where their first size can be told, and it is said.

--check lays a sample of the frames into one another instead, and tells whether depth scale,
intrinsics and poses hold together, or what fits better. It ends with 0 if nothing speaks against
them, 3 if something does, 4 if nothing can be compared.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Number<int64_t> last{*this, "--to", "N",
                               "Last frame to take, by number (default: the last)",
                               std::numeric_limits<int64_t>::max()};
    apps::Number<int64_t> first{*this, "--from", "N", "First frame to take, by number (default: 0)",
                                0};
    apps::Number<size_t> every{*this, "--every", "N",
                               "Take every so-manieth frame only (default: 1)", 1};
    apps::TrustPathsArgument trustPaths{*this};
    apps::Switch strict{
        *this, "--strict",
        "Frames that cannot be used, odd predictions and odd lines of lists are errors"};
    apps::Text poseAxes{
        *this, "--pose-axes", "AXES",
        "Axes of the camera that the dataset's poses are of: optical (x right, y down, z forward; "
        "default), opengl (x right, y up, z backward), body (x forward, y left, z up)",
        "optical"};
    apps::Switch invertPoses{*this, "--invert-poses",
                             "The dataset's poses are world-to-camera transforms"};
    apps::Number<double> depthScale{
        *this, "--depth-scale", "N",
        "Numbers in the depth images that make a metre (default: the format's)", 0};
    apps::Text intrinsics{*this, "--intrinsics", "FX,FY,CX,CY",
                          "Camera of the depth images, and of colour images registered to them "
                          "[pixels] (default: the dataset's)"};
    apps::Text colourIntrinsics{*this, "--color-intrinsics", "FX,FY,CX,CY",
                                "Camera of the colour images, which then need not be registered to "
                                "the depth images [pixels] (default: the dataset's)"};
    apps::Switch check{
        *this, "--check",
        "Tell whether depth scale, intrinsics and poses hold together; write nothing"};
    apps::Text images{*this, "--images", "WHERE", "Where images go: external (default), embedded",
                      "external"};
    apps::Switch embed{*this, "--embed", "Put the predictions into the rawlog"};
    apps::Text categories{*this, "--categories", "FILE",
                          "Names of the categories the predictions give numbers of: JSON as COCO "
                          "has, CSV lines 'id,name', names alone, or data.yaml (default: COCO's)"};
    apps::Text predictions{
        *this, "--predictions", "FILE.json|gt",
        "A detector's predictions in the COCO results format; image_id is the frame's number, or "
        "the name of its image, or of an image the file lists; or gt: the dataset's own "
        "annotation, with its objects as tracks (scannet, scenenn)"};
    apps::Text output{*this, "-o,--output", "FILE.rawlog", "Rawlog to write"};
    apps::Text input{*this, "-i,--input", "DIR", "Folder of the dataset (scannet: or a .sens file)",
                     apps::Presence::required};
    apps::Text format{*this, "-f,--format", "NAME",
                      "Format of the dataset: " + joined(datasetFormats(), ", "),
                      apps::Presence::required};

    bool wantsAnnotation() { return predictions.value() == "gt"; }
};

void checkArguments(Arguments& arguments)
{
    const std::string& images = arguments.images.value();
    if (images != "external" && images != "embedded")
        throw ConfigurationError("--images must be external or embedded, not " + images);
    if (arguments.output.isSet() == arguments.check.isSet())
        throw ConfigurationError("give one of --output and --check (see --help)");
    if (arguments.categories.isSet() &&
        (!arguments.predictions.isSet() || arguments.wantsAnnotation()))
        throw ConfigurationError("--categories needs --predictions with a file");
    if (arguments.depthScale.isSet() && !isDepthScale(arguments.depthScale.value()))
        throw ConfigurationError("--depth-scale " + numberText(arguments.depthScale.value()) +
                                 " cannot be: " + DEPTH_SCALES);
    apps::checkOutputs({{}, {arguments.output.value()}, {}},
                       {{arguments.wantsAnnotation() ? "" : arguments.predictions.value(),
                         arguments.categories.value()},
                        {},
                        {arguments.input.value()}});
}

/** The camera that an option gives, if it is set. */
std::optional<PinholeCamera> intrinsicsOf(const apps::Text& option)
{
    if (!option.isSet()) return std::nullopt;
    const auto numbers = apps::numbersIn(option.value(), 4);
    if (numbers.empty() || !(numbers[0] > 0) || !(numbers[1] > 0))
        throw ConfigurationError(option.name() + " '" + option.value() +
                                 "' is not four numbers like 525,525,319.5,239.5");
    return PinholeCamera{numbers[0], numbers[1], numbers[2], numbers[3], {}};
}

std::unique_ptr<RgbdDatasetReader> open(Arguments& arguments)
{
    DatasetOptions options;
    options.annotation = arguments.wantsAnnotation() && !arguments.check.isSet();
    options.invertPoses = arguments.invertPoses.isSet();
    options.poseAxes = poseAxesNamed(arguments.poseAxes.value(), "--pose-axes");
    if (arguments.depthScale.isSet()) options.depthScale = arguments.depthScale.value();
    options.camera = intrinsicsOf(arguments.intrinsics);
    options.colourCamera = intrinsicsOf(arguments.colourIntrinsics);
    options.strict = arguments.strict.isSet();
    options.trustPaths = arguments.trustPaths.isSet();
    auto dataset = openDataset(arguments.format.value(), arguments.input.value(), options);
    dataset->select(arguments.first.value(), arguments.last.value(), arguments.every.value());
    return dataset;
}

void printNotes(const RgbdDatasetReader& dataset)
{
    for (const std::string& note : dataset.notes())
        std::cout << "note: " << printableSentence(note, apps::LONGEST_NOTE) << "\n";
}

void printSkipped(const std::vector<SkippedFrame>& skipped)
{
    constexpr size_t NAMED = 3;
    std::map<std::string, std::vector<std::string>> byReason;
    for (const auto& s : skipped) byReason[s.reason].push_back(s.frame.image);
    for (auto& [reason, names] : byReason) {
        const size_t n = names.size();
        names.resize(std::min(n, NAMED));
        std::cout << "skipped: " << counted(n, "frame") << ", " << printableSentence(reason) << " ("
                  << printableSentence(joined(names, ", ")) << (n > NAMED ? ", ..." : "") << ")\n";
    }
}

void printPredictions(const ImportSummary& summary)
{
    std::cout << "predictions: " << summary.predictions;
    if (summary.predictionsLeftOut > 0)
        std::cout << ", and " << summary.predictionsLeftOut << " of frames that were left out";
    std::cout << "\n";
}

/** Bytes of a file or of all files in a folder; 0 if there is none. */
uintmax_t sizeOf(const fs::path& path)
{
    if (fs::is_regular_file(path)) return fs::file_size(path);
    uintmax_t bytes = 0;
    if (fs::is_directory(path))
        for (const auto& file : fs::directory_iterator(path)) bytes += fs::file_size(file);
    return bytes;
}

void printSizes(const RawlogFiles& files)
{
    for (const auto& path : {files.rawlog, files.sidecar, files.images}) {
        const auto bytes = static_cast<double>(sizeOf(path));
        if (bytes == 0) continue;
        const bool large = bytes >= 1e6;
        std::cout << "written: " << printable(path.string(), UNCUT) << ", " << std::fixed
                  << std::setprecision(1) << bytes / (large ? 1e6 : 1e3)
                  << (large ? " MB\n" : " kB\n");
    }
}

/** The predictions' file, if one is given. */
std::optional<CocoPredictions> readPredictions(Arguments& arguments)
{
    if (!arguments.predictions.isSet() || arguments.wantsAnnotation()) return std::nullopt;
    CategoryNames names;
    if (arguments.categories.isSet()) names = readCategoryNames(arguments.categories.value());
    return CocoPredictions(arguments.predictions.value(), names, arguments.strict.isSet());
}

RgbdRawlogWriter::Options writerOptions(Arguments& arguments, const RgbdDatasetReader& dataset)
{
    RgbdRawlogWriter::Options options;
    options.embedInstances = arguments.embed.isSet();
    options.embedImages = arguments.images.value() == "embedded";
    options.comment = "Made by rgbd2rawlog from " + dataset.name();
    return options;
}

int makeRawlog(Arguments& arguments)
{
    const std::string& output = arguments.output.value();
    const auto dataset = open(arguments);
    const auto recorded = readPredictions(arguments);
    std::optional<MatchedPredictions> predictions;
    if (recorded) predictions.emplace(*recorded, dataset->frames());
    RgbdRawlogWriter writer(output, writerOptions(arguments, *dataset));
    ImportSummary summary;
    {
        apps::Progress progress("frames", dataset->selected().size(), !arguments.quiet());
        summary = importDataset(*dataset, predictions ? &*predictions : nullptr, writer,
                                [&](size_t done) { progress.update(done); });
    }
    writer.close();

    std::cout << "frames: " << summary.frames << " of " << dataset->frames().size() << " in "
              << printable(dataset->name()) << "\n";
    printNotes(*dataset);
    printSkipped(dataset->skipped());
    if (arguments.predictions.isSet()) printPredictions(summary);
    if (predictions) {
        for (const std::string& note : predictions->notes()) arguments.note(note);
        for (const std::string& warning : predictions->warnings()) arguments.warn(warning);
    }
    printSizes(RawlogFiles(output));
    return 0;
}

int checkDataset(Arguments& arguments)
{
    using Verdict = CalibrationFinding::Verdict;
    const auto dataset = open(arguments);
    CalibrationFinding finding;
    {
        apps::Progress progress("frames", 0, !arguments.quiet());
        finding = checkCalibration(*dataset, [&](size_t read) { progress.update(read); });
    }
    std::cout << "frames: " << dataset->selected().size() << " of " << dataset->frames().size()
              << " in " << printable(dataset->name()) << "\n";
    printNotes(*dataset);
    std::cout << finding.text();
    if (finding.verdict == Verdict::nothing) return 4;
    return finding.verdict == Verdict::contradiction ? 3 : 0;
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    checkArguments(arguments);
    return arguments.check.isSet() ? checkDataset(arguments) : makeRawlog(arguments);
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("rgbd2rawlog", [&] { return run(argc, argv); });
}
