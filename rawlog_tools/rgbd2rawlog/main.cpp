// SPDX-License-Identifier: BSD-3-Clause
/** Makes a rawlog from a public RGB-D dataset. */
#include "common/CommandLine.h"
#include "common/Progress.h"
#include "voxeland/datasets/DatasetImport.h"
#include "voxeland/errors.h"
#include "voxeland/io/RawlogFiles.h"

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

  rgbd2rawlog --format 7scenes --input redkitchen --output k.rawlog
  rgbd2rawlog --format 7scenes --input redkitchen/seq-01 --predictions coco.json --output k.rawlog
  rgbd2rawlog --format 7scenes --input redkitchen --check

Beside k.rawlog, which any MRPT program reads, it writes the images to k_Images (--images embedded:
into the rawlog) and the predictions to k.instances.rawlog (--embed: into the rawlog, which then
needs programs that load libvoxeland). Frames with a missing file or without a valid pose are left
out and listed.)";

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
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

void printSkipped(const std::vector<SkippedFrame>& skipped)
{
    constexpr size_t NAMED = 3;
    std::map<std::string, std::vector<std::string>> byReason;
    for (const auto& s : skipped) byReason[s.reason].push_back(s.frame.image);
    for (auto& [reason, names] : byReason) {
        const size_t n = names.size();
        names.resize(std::min(n, NAMED));
        std::cout << "skipped: " << n << " frames, " << reason << " (" << joined(names)
                  << (n > NAMED ? ", ..." : "") << ")\n";
    }
}

void printSizes(const RawlogFiles& files)
{
    for (const auto& path : {files.rawlog, files.sidecar, files.images})
        if (const auto bytes = sizeOf(path); bytes > 0)
            std::cout << "written: " << path.string() << ", " << std::fixed << std::setprecision(1)
                      << static_cast<double>(bytes) / 1e6 << " MB\n";
}

int run(int argc, char** argv)
{
    const std::string formats = joined(datasetFormats());
    apps::CommandLine commandLine(DESCRIPTION);
    auto& parser = commandLine.parser();
    TCLAP::ValueArg<int64_t> last("", "to", "Last frame to take, by number (default: the last)",
                                  false, std::numeric_limits<int64_t>::max(), "N", parser);
    TCLAP::ValueArg<int64_t> first("", "from", "First frame to take, by number (default: 0)", false,
                                   0, "N", parser);
    TCLAP::ValueArg<size_t> every("", "every", "Take every so-manieth frame only (default: 1)",
                                  false, 1, "N", parser);
    TCLAP::SwitchArg check("", "check", "Read and check everything, write nothing", parser);
    TCLAP::ValueArg<std::string> images("", "images",
                                        "Where images go: external (default), embedded", false,
                                        "external", "WHERE", parser);
    TCLAP::SwitchArg embed("", "embed", "Put the predictions into the rawlog", parser);
    TCLAP::ValueArg<std::string> categories(
        "", "categories",
        "Names of the categories the predictions give numbers of: JSON as COCO has,"
        " or CSV lines 'id,name' (default: COCO's 91)",
        false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> predictionsFile(
        "", "predictions",
        "A detector's predictions, in the COCO results format; image_id is the"
        " frame number",
        false, "", "FILE.json", parser);
    TCLAP::ValueArg<std::string> output("o", "output", "Rawlog to write", false, "", "FILE.rawlog",
                                        parser);
    TCLAP::ValueArg<std::string> input("i", "input", "Folder of the dataset", true, "", "DIR",
                                       parser);
    TCLAP::ValueArg<std::string> format("f", "format", "Format of the dataset: " + formats, true,
                                        "", "NAME", parser);
    if (!commandLine.parse(argc, argv)) return 0;
    if (images.getValue() != "external" && images.getValue() != "embedded")
        throw ConfigurationError("--images must be external or embedded, not " + images.getValue());
    if (output.isSet() == check.isSet())
        throw ConfigurationError("give one of --output and --check (see --help)");
    if (categories.isSet() && !predictionsFile.isSet())
        throw ConfigurationError("--categories needs --predictions");

    const auto dataset = openDataset(format.getValue(), input.getValue());
    dataset->select(first.getValue(), last.getValue(), every.getValue());
    std::optional<CocoPredictions> predictions;
    if (predictionsFile.isSet())
        predictions.emplace(
            predictionsFile.getValue(),
            categories.isSet() ? readCategoryNames(categories.getValue()) : CategoryNames());
    std::optional<RgbdRawlogWriter> writer;
    if (output.isSet()) {
        RgbdRawlogWriter::Options options;
        options.embedInstances = embed.isSet();
        options.embedImages = images.getValue() == "embedded";
        options.comment = "Made by rgbd2rawlog from " + dataset->name();
        writer.emplace(output.getValue(), options);
    }

    ImportSummary summary;
    {
        apps::Progress progress("frames", dataset->selectedCount(), !commandLine.quiet());
        summary =
            importDataset(*dataset, predictions ? &*predictions : nullptr,
                          writer ? &*writer : nullptr, [&](size_t done) { progress.update(done); });
    }
    if (writer) writer->close();

    std::cout << "frames: " << summary.frames << " of " << dataset->frames().size() << " in "
              << dataset->name() << "\n";
    printSkipped(dataset->skipped());
    if (predictions) {
        std::cout << "predictions: " << summary.predictions;
        if (summary.predictionsLeftOut > 0)
            std::cout << ", and " << summary.predictionsLeftOut << " of frames that were left out";
        if (summary.predictionsWithoutFrame > 0)
            std::cout << ", and " << summary.predictionsWithoutFrame
                      << " of frames that do not exist";
        std::cout << "\n";
    }
    if (writer) printSizes(RawlogFiles(output.getValue()));
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("rgbd2rawlog", [&] { return run(argc, argv); });
}
