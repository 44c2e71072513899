// SPDX-License-Identifier: BSD-3-Clause
#include "common/CommandLine.h"
#include "common/Progress.h"
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

/** The program's own options. */
class Arguments
{
 public:
    explicit Arguments(TCLAP::CmdLine& parser)
        : m_output("o", "output", "The rawlog to write, ending in .rawlog", true, "", "FILE",
                   parser),
          m_groundTruth("", "gt", "Folder for the ground truth; created if absent", false, "",
                        "DIR", parser),
          m_seed("", "seed", "Chooses the apartment and all errors (default 1)", false, 1, "N",
                 parser),
          m_frames("", "frames", "Images of the tour through all rooms (default 300)", false, 300,
                   "N", parser),
          m_rooms("", "rooms", "Number of rooms, 1 to 3 (default 2)", false, 2, "N", parser),
          m_detector("", "detector",
                     "How wrong the detector is: perfect, mild, realistic (default) or hard", false,
                     "realistic", "NAME", parser),
          m_width("", "width", "Width of the images [pixels] (default 640)", false, 640, "N",
                  parser),
          m_height("", "height", "Height of the images [pixels] (default 480)", false, 480, "N",
                   parser),
          m_exactDepth("", "exact-depth", "Depth without noise and dropouts", parser),
          m_drift(
              "", "drift",
              "The poses in the rawlog drift, and tell their covariance; without, they are exact",
              parser),
          m_jitter("", "jitter",
                   "Each pose has an error of its own, larger at some times than at others, and "
                   "tells its covariance",
                   parser),
          m_tracks("", "tracks",
                   "true: predictions carry the object's true identity as track id (default false)",
                   false, "false", "true|false", parser),
          m_painted("", "paint",
                    "Every object has the colour of its category, so that a program can tell from "
                    "an image what it shows",
                    parser),
          m_robot("", "robot",
                  "The camera rides on a robot with a laser scanner and odometry; poses are the "
                  "robot's",
                  parser),
          m_sensoryFrames("", "sensory-frames",
                          "Write actions and sensory frames, as rbpf-slam needs them", parser),
          m_embed("", "embed", "Predictions inside the rawlog instead of a sidecar", parser),
          m_images("", "images",
                   "external (default): images in a folder beside the rawlog; embedded: inside it",
                   false, "external", "WHERE", parser),
          m_threads("", "threads", "Frames computed at a time (default: one a core)", false, 0, "N",
                    parser)
    {
    }

    SimulationOptions options()
    {
        SimulationOptions o;
        o.seed = m_seed.getValue();
        o.scene.rooms = m_rooms.getValue();
        o.scene.painted = m_painted.getValue();
        o.camera.frames = m_frames.getValue();
        o.camera.width = m_width.getValue();
        o.camera.height = m_height.getValue();
        o.depth.enabled = !m_exactDepth.getValue();
        o.drift.enabled = m_drift.getValue();
        o.robot.enabled = m_robot.getValue();
        o.jitter.enabled = m_jitter.getValue();
        o.detector = DetectorOptions::preset(m_detector.getValue());
        o.detector.tracks = isFirst(m_tracks, "true", "false");
        return o;
    }

    SimulationOutput output()
    {
        SimulationOutput o;
        o.rawlog = m_output.getValue();
        o.rawlogOptions.embedInstances = m_embed.getValue();
        o.rawlogOptions.embedImages = isFirst(m_images, "embedded", "external");
        o.rawlogOptions.sensoryFrames = m_sensoryFrames.getValue();
        o.rawlogOptions.comment = "simulated by voxeland-simulate, seed " +
                                  std::to_string(m_seed.getValue()) + ", detector " +
                                  m_detector.getValue();
        o.groundTruthFolder = m_groundTruth.getValue();
        o.threads = m_threads.getValue();
        return o;
    }

 private:
    /** \throws ConfigurationError if the value is neither of the two */
    static bool isFirst(TCLAP::ValueArg<std::string>& argument, const std::string& first,
                        const std::string& second)
    {
        const std::string& value = argument.getValue();
        if (value == first || value == second) return value == first;
        throw ConfigurationError("--" + argument.getName() + " must be " + first + " or " + second +
                                 ", not '" + value + "'");
    }

    TCLAP::ValueArg<std::string> m_output, m_groundTruth;
    TCLAP::ValueArg<uint64_t> m_seed;
    TCLAP::ValueArg<int> m_frames, m_rooms;
    TCLAP::ValueArg<std::string> m_detector;
    TCLAP::ValueArg<int> m_width, m_height;
    TCLAP::SwitchArg m_exactDepth, m_drift, m_jitter;
    TCLAP::ValueArg<std::string> m_tracks;
    TCLAP::SwitchArg m_painted, m_robot, m_sensoryFrames, m_embed;
    TCLAP::ValueArg<std::string> m_images;
    TCLAP::ValueArg<unsigned> m_threads;
};

int run(int argc, char** argv)
{
    apps::CommandLine commandLine(DESCRIPTION);
    Arguments arguments(commandLine.parser());
    if (!commandLine.parse(argc, argv)) return 0;

    const SimulationOptions options = arguments.options();
    const SimulationOutput output = arguments.output();
    apps::Progress progress("frames", static_cast<size_t>(std::max(0, options.camera.frames)),
                            !commandLine.quiet());
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
