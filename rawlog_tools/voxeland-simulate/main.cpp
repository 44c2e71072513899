// SPDX-License-Identifier: BSD-3-Clause
#include "common/CommandLine.h"
#include "common/Progress.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "simulation/SimulationRun.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"

#include <algorithm>
#include <iostream>

using namespace voxeland;
using namespace voxeland::simulation;

namespace
{
constexpr auto DESCRIPTION =
    R"(Simulates an RGB-D camera carried through a furnished apartment, with a noisy instance detector,
and writes a rawlog with poses and predictions, and the ground truth.

Examples:
  voxeland-simulate -o sim.rawlog
      a living room and a bedroom, 300 frames, the realistic detector
  voxeland-simulate -o sim.rawlog --gt truth --seed 7 --rooms 3 --frames 600 --detector hard
      another, larger apartment, with the ground truth for voxeland-eval
  voxeland-simulate -o small.rawlog --rooms 1 --frames 60 --width 320 --height 240 --embed
      small and quick; predictions inside the rawlog
  voxeland-simulate -o robot.rawlog --robot --embed
      with a 2D laser scanner and odometry, for icp-slam and pf-localization

The same options always give the same apartment, images and predictions.
Ground truth folder: ground_truth.ply (x y z instance category of all surfaces the camera has seen),
categories.csv, objects.csv, trajectory.tum.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Text rawlog{*this, "-o,--output", "FILE", "The rawlog to write, ending in .rawlog",
                      apps::Presence::required};
    apps::Text groundTruth{*this, "--gt", "DIR", "Folder for the ground truth; created if absent"};
    apps::Number<uint64_t> seed{*this, "--seed", "N",
                                "Chooses the apartment and all errors (default 1)", 1};
    apps::Number<int> frames{*this, "--frames", "N",
                             "Images of the tour through all rooms (default 300)", 300};
    apps::Number<int> rooms{*this, "--rooms", "N", "Number of rooms, 1 to 3 (default 2)", 2};
    apps::Text detector{*this, "--detector", "NAME",
                        "How wrong the detector is: perfect, mild, realistic (default) or hard",
                        "realistic"};
    apps::Number<int> width{*this, "--width", "N", "Width of the images [pixels] (default 640)",
                            640};
    apps::Number<int> height{*this, "--height", "N", "Height of the images [pixels] (default 480)",
                             480};
    apps::Switch exactDepth{*this, "--exact-depth", "Depth without noise and dropouts"};
    apps::Switch drift{
        *this, "--drift",
        "The poses in the rawlog drift, and tell their covariance; without, they are exact"};
    apps::Switch jitter{*this, "--jitter",
                        "Each pose has an error of its own, larger at some times than at others, "
                        "and tells its covariance"};
    apps::Text tracks{
        *this, "--tracks", "true|false",
        "true: predictions carry the object's true identity as track id (default false)", "false"};
    apps::Switch painted{*this, "--paint",
                         "Every object has the colour of its category, so that a program can tell "
                         "from an image what it shows"};
    apps::Switch robot{
        *this, "--robot",
        "The camera rides on a robot with a laser scanner and odometry; poses are the robot's"};
    apps::Switch sensoryFrames{*this, "--sensory-frames",
                               "Write actions and sensory frames, as rbpf-slam needs them"};
    apps::Switch embed{*this, "--embed", "Predictions inside the rawlog instead of a sidecar"};
    apps::Text images{
        *this, "--images", "WHERE",
        "external (default): images in a folder beside the rawlog; embedded: inside it",
        "external"};
    apps::Number<unsigned> threads{*this, "--threads", "N",
                                   "Frames computed at a time (default: one a core)", 0};

    [[nodiscard]] SimulationOptions options() const
    {
        SimulationOptions o;
        o.seed = seed.value();
        o.scene.rooms = rooms.value();
        o.scene.painted = painted.isSet();
        o.camera.frames = frames.value();
        o.camera.width = width.value();
        o.camera.height = height.value();
        o.depth.enabled = !exactDepth.isSet();
        o.drift.enabled = drift.isSet();
        o.robot.enabled = robot.isSet();
        o.jitter.enabled = jitter.isSet();
        o.detector = DetectorOptions::preset(detector.value());
        o.detector.tracks = isFirst(tracks, "true", "false");
        return o;
    }

    [[nodiscard]] SimulationOutput output() const
    {
        SimulationOutput o;
        o.rawlog = rawlog.value();
        o.rawlogOptions.embedInstances = embed.isSet();
        o.rawlogOptions.embedImages = isFirst(images, "embedded", "external");
        o.rawlogOptions.sensoryFrames = sensoryFrames.isSet();
        o.rawlogOptions.comment = "simulated by voxeland-simulate, seed " +
                                  std::to_string(seed.value()) + ", detector " + detector.value();
        o.groundTruthFolder = groundTruth.value();
        o.threads = threads.value();
        return o;
    }

 private:
    /** \throws ConfigurationError if the value is neither of the two */
    static bool isFirst(const apps::Text& argument, const std::string& first,
                        const std::string& second)
    {
        const std::string& value = argument.value();
        if (value == first || value == second) return value == first;
        throw ConfigurationError(argument.name() + " must be " + first + " or " + second +
                                 ", not '" + value + "'");
    }
};

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;

    const SimulationOptions options = arguments.options();
    const SimulationOutput output = arguments.output();
    apps::checkOutputs({{}, {output.rawlog}, {output.groundTruthFolder}}, {});
    apps::Progress progress("frames", static_cast<size_t>(std::max(0, options.camera.frames)),
                            !arguments.quiet());
    const auto made =
        runSimulation(options, output, [&](size_t frames) { progress.update(frames); });
    std::cout << printable(output.rawlog, UNCUT) << ": " << counted(made.frames, "frame") << ", "
              << counted(made.rooms, "room") << ", " << counted(made.objects, "object") << ", "
              << counted(made.predictions, "prediction") << "\n";
    if (!output.groundTruthFolder.empty())
        std::cout << printable(output.groundTruthFolder, UNCUT) << ": "
                  << counted(made.groundTruthPoints, "point") << " of surfaces seen\n";
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-simulate", [&] { return run(argc, argv); });
}
