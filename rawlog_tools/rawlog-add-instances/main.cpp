// SPDX-License-Identifier: BSD-3-Clause
/** Adds a detector's predictions to a rawlog. */
#include "common/CommandLine.h"
#include "common/Progress.h"
#include "voxeland/datasets/RawlogPredictions.h"
#include "voxeland/io/RawlogFiles.h"

#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION = R"(Adds a detector's predictions to a rawlog with RGB-D frames.

  rawlog-add-instances -i k.rawlog --coco results.json -o k.rawlog
  rawlog-add-instances -i k.rawlog --coco results.json --categories cats.json -o k2.rawlog
  rawlog-add-instances -i k.rawlog --coco results.json --embed -o embedded.rawlog

image_id counts the rawlog's RGB-D frames from 0. The predictions go to the file
NAME.instances.rawlog beside the output NAME.rawlog, which is a copy of the input unless both are
the same; its external images are found through a link. With --embed they go into the output, which
then needs programs that load libvoxeland.)";

int run(int argc, char** argv)
{
    apps::CommandLine commandLine(DESCRIPTION);
    auto& parser = commandLine.parser();
    TCLAP::ValueArg<std::string> label("", "sensor-label",
                                       "Which sensor's RGB-D frames, where there are several's",
                                       false, "", "LABEL", parser);
    TCLAP::SwitchArg embed("", "embed", "Put the predictions into the rawlog", parser);
    TCLAP::ValueArg<std::string> categories(
        "", "categories",
        "Names of the categories the predictions give numbers of: JSON as COCO has,"
        " or CSV lines 'id,name' (default: COCO's 91)",
        false, "", "FILE", parser);
    TCLAP::ValueArg<std::string> output("o", "output", "Rawlog to write; may be the input", true,
                                        "", "OUT.rawlog", parser);
    TCLAP::ValueArg<std::string> coco("", "coco", "Predictions in the COCO results format", true,
                                      "", "RESULTS.json", parser);
    TCLAP::ValueArg<std::string> input("i", "input", "Rawlog to read", true, "", "IN.rawlog",
                                       parser);
    if (!commandLine.parse(argc, argv)) return 0;

    const CocoPredictions predictions(
        coco.getValue(),
        categories.isSet() ? readCategoryNames(categories.getValue()) : CategoryNames());
    AddPredictionsOptions options;
    options.embed = embed.isSet();
    options.sensorLabel = label.getValue();
    AddedPredictions added;
    {
        apps::Progress progress("frames", 0, !commandLine.quiet());
        added =
            addPredictions(input.getValue(), predictions, output.getValue(), options,
                           [&](size_t frames, double share) { progress.update(frames, share); });
    }

    const RawlogFiles files(output.getValue());
    std::cout << "frames: " << added.frames << "\npredictions: " << added.predictions;
    if (added.predictionsWithoutFrame > 0)
        std::cout << ", and " << added.predictionsWithoutFrame << " of frames that do not exist";
    std::cout << "\n";
    if (added.replaced > 0)
        std::cout << "replaced: predictions of " << added.replaced << " frames\n";
    if (added.rawlogWritten) std::cout << "written: " << files.rawlog.string() << "\n";
    if (!embed.isSet()) std::cout << "written: " << files.sidecar.string() << "\n";
    if (added.imagesLinked)
        std::cout << "linked: " << files.images.string() << ", to the images of "
                  << input.getValue() << "\n";
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("rawlog-add-instances", [&] { return run(argc, argv); });
}
