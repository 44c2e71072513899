// SPDX-License-Identifier: BSD-3-Clause
/** Makes a semantic voxel map from a rawlog. */
#include "answers/AnswersAsText.h"
#include "common/CommandLine.h"
#include "common/Interruption.h"
#include "common/Progress.h"
#include "common/SetArgument.h"
#include "common/TrustPathsArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "pipeline/MappingTrace.h"
#include "pipeline/TimingLog.h"
#include "plugins/PluginLoader.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/exporters/ExportAll.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/metric_map/MapFile.h"
#include "voxeland/metric_map/RawlogMapping.h"

#include <filesystem>
#include <iostream>
#include <limits>
#include <map>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Makes a semantic voxel map with uncertainty from a rawlog of RGB-D frames and predictions.

  rawlog2voxeland -i kitchen.rawlog -o kitchen.voxeland --export-dir kitchen
  rawlog2voxeland -i robot.rawlog -o map.voxeland --poses robot.tum --set map.resolution=0.03
  rawlog2voxeland -i desk.rawlog -o desk.voxeland --poses orbslam.txt --pose-axes optical
  rawlog2voxeland -i part2.rawlog -o whole.voxeland --resume part1.voxeland
  rawlog2voxeland -i kitchen.rawlog -o kitchen.voxeland --trace kitchen.jsonl
  rawlog2voxeland --dump-config > my.ini

Without -c the defaults hold: predictions recorded in the rawlog or in NAME.instances.rawlog beside it,
the paper's association, 5 cm voxels. --dump-config prints the keys of the INI with their meaning.
Ctrl-C, SIGTERM or SIGHUP saves the map of the frames so far and prints the command that goes on; a
second one ends at once.
Per cent and time left count frames, whose number is estimated from what was read of the rawlog.
Exit codes: 0 done, 1 usage or configuration, 2 plugin, 3 input, 4 nothing to map, 5 output,
130 interrupted.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Switch listPlugins{*this, "--list-plugins", "Print the plugins that are there, and end"};
    apps::Switch checkConfig{*this, "--check-config", "Check the configuration, and end"};
    apps::SwitchOrText dumpConfig{
        *this, "--dump-config", "all",
        "Print the effective configuration as an INI, the keys that users change or \"all\", and "
        "end"};
    apps::Text trace{*this, "--trace", "FILE.jsonl",
                     "Write why each opinion, division and merge was decided as it was"};
    apps::Text timing{*this, "--timing", "FILE.csv", "Write each frame's CPU time per stage [ms]"};
    apps::Text resume{
        *this, "--resume", "MAP.voxeland",
        "Go on with this map instead of an empty one; frames it was made from are left out"};
    apps::SetArgument set{*this, "configuration"};
    apps::Number<uint32_t> every{*this, "--every", "N", "Use one frame in so many (default: 1)", 1};
    apps::Number<uint32_t> to{*this, "--to", "N",
                              "Last frame to use, by number (default: the last)",
                              std::numeric_limits<uint32_t>::max()};
    apps::Number<uint32_t> from{*this, "--from", "N", "First frame to use, by number (default: 0)",
                                0};
    apps::Text exportDir{*this, "--export-dir", "DIR",
                         "Also write PLY, JSON, CSV and pictures of the map into this folder"};
    apps::TrustPathsArgument trustPaths{*this};
    apps::Switch strict{*this, "--strict",
                        "An odd pose, or a frame whose depth image cannot be used, is an error "
                        "instead of left out and told"};
    apps::Text poseAxes{
        *this, "--pose-axes", "AXES",
        "What the poses are of: body, the robot (default); optical, the depth camera (x right, y "
        "down, z forward: TUM, ORB-SLAM); opengl, it too (x right, y up, z backward)"};
    apps::Text poses{*this, "--poses", "FILE.tum",
                     "Trajectory in TUM format, instead of the rawlog's poses; of the robot, or "
                     "see --pose-axes"};
    apps::Text output{*this, "-o,--output", "MAP.voxeland", "Map to write"};
    apps::Text input{*this, "-i,--input", "FILE.rawlog", "Rawlog or simplemap to read"};
    apps::Text config{*this, "-c,--config", "FILE.ini", "Configuration (default: all defaults)"};
};

/** The INI to use: that of the command line, that of the map to resume, or defaults. */
Ini configuration(Arguments& arguments, const CVoxelandMap* resumed)
{
    Ini ini;
    if (arguments.config.isSet())
        ini = Ini::fromFile(arguments.config.value());
    else if (resumed != nullptr)
        ini = Ini::fromMap(resumed->configText(), arguments.resume.value());
    if (arguments.poses.isSet()) ini.set("voxeland.pose_source=tum:" + arguments.poses.value());
    if (arguments.poseAxes.isSet())
        ini.set("voxeland.pose_axes=" +
                nameOf(poseAxesNamed(arguments.poseAxes.value(), "--pose-axes")));
    arguments.set.applyTo(ini);
    return ini;
}

void printSummary(const CVoxelandMap& map, const TimingLog& timing)
{
    std::cout << asText(overviewOf(map.map(), map.counts()));
    if (const uint32_t n = map.counts().predictionsWithoutFrame; n > 0)
        std::cout << "left out       predictions of " << counted(n, "frame")
                  << " not in the rawlog\n";
    timing.printSummary(std::cout);
}

/** Warns of what was left out, or came to nothing. */
void warnOf(Arguments& arguments, const MappedInput& met)
{
    constexpr double FEW = 0.05;  // of the depths measured
    // Right poses give 0.02 to 0.15, with much jitter 0.28; wrong ones 0.5 to 0.8.
    constexpr double MUCH = 0.4;
    constexpr uint64_t ENOUGH = 500;
    if (met.leftOut.count() > 0) arguments.warn(met.leftOut.told("frame"));
    if (met.repeated > 0)
        arguments.warn("left out " + counted(met.repeated, "frame") +
                       ", of a time and place that the map has a frame of already");
    const auto measured = static_cast<double>(met.depths.pixels);
    if (static_cast<double>(met.depths.used) < FEW * measured)
        arguments.warn("only " +
                       fixedText(100 * static_cast<double>(met.depths.used) / measured, 1) +
                       " % of the depths, of " + fixedText(met.depths.nearest, 3) + " to " +
                       fixedText(met.depths.farthest, 3) +
                       " m, lie between min_depth and max_depth: check the scans' rangeUnits");
    if (met.surfaces.known() > ENOUGH && met.surfaces.contradiction() > MUCH)
        arguments.warn(fixedText(100 * met.surfaces.contradiction(), 0) +
                       " % of what the frames measured lies where earlier ones saw free space: the "
                       "poses do not fit; a camera's own trajectory needs --pose-axes optical or "
                       "opengl, and times or rangeUnits may be wrong");
    if (met.predictions > 0 && met.opinions == 0)
        arguments.warn("none of " + counted(met.predictions, "prediction") +
                       " became an opinion: no mask has enough depth in it; check the camera "
                       "parameters and relativePoseIntensityWRTDepth");
}

/** What a run did. */
struct Run
{
    TimingLog timing;
    uint32_t frames = 0;                    //!< mapped
    std::optional<uint32_t> stoppedBefore;  //!< first frame that an interrupted run left out
};

/** Maps the rawlog, or what of it comes before the user interrupts the program.
 *  \throws apps::Interrupted if that is nothing */
Run mapFrames(Arguments& arguments, CVoxelandMap& map, const apps::Interruption& interruption)
{
    RawlogFrameSource source(
        arguments.input.value(), map.withCamera(map.mapper().config().input),
        {arguments.from.value(), arguments.to.value(), arguments.every.value()},
        arguments.strict.isSet());
    source.stopWhen([&] { return interruption.wasRequested(); });
    apps::Progress progress("frames", 0, !arguments.quiet());
    Run run;
    const auto onFrame = [&](const StageTimes& times) {
        run.timing.add(times);
        ++run.frames;
        progress.update(run.frames, static_cast<double>(run.frames) / source.expectedFrames());
    };
    const MappedInput met = mapRawlog(source, map, onFrame, arguments.strict.isSet());
    run.stoppedBefore = source.stoppedBefore();
    if (run.stoppedBefore && run.frames == 0)
        throw apps::Interrupted("interrupted before a frame was mapped: nothing was written");
    warnOf(arguments, met);
    for (const std::string& note : source.notes()) arguments.warn(note);
    return run;
}

/** Maps the rawlog and saves the map, with a trace if one is asked for: both or none. */
Run mapAndSave(Arguments& arguments, CVoxelandMap& map)
{
    const apps::Interruption interruption;
    Run run;
    const auto save = [&] { saveMap(map, arguments.output.value()); };
    if (!arguments.trace.isSet()) {
        run = mapFrames(arguments, map, interruption);
        save();
        return run;
    }
    writeAtomically(arguments.trace.value(), [&](std::ostream& out) {
        map.setTrace(std::make_shared<MappingTrace>(out, map.mapper().config()));
        run = mapFrames(arguments, map, interruption);
        map.setTrace(nullptr);
        out.flush();  // a full disk must show before an earlier map is replaced
        save();
    });
    return run;
}

/** Name of a file beside one of an interrupted run, for the frames from a number on. */
std::string continued(const std::string& file, uint32_t from)
{
    std::filesystem::path path = file;
    const std::string extension = path.extension().string();
    return path.replace_extension(".from" + std::to_string(from) + extension).string();
}

/** Ends an interrupted run, with the command that goes on. */
[[noreturn]] void endInterrupted(Arguments& arguments, const Run& run)
{
    const std::string& output = arguments.output.value();
    const uint32_t next = *run.stoppedBefore;
    std::map<std::string, std::string> values = {{"--resume", output},
                                                 {"--from", std::to_string(next)}};
    for (auto* file : {&arguments.trace, &arguments.timing})
        if (file->isSet()) values[file->name()] = continued(file->value(), next);
    throw apps::Interrupted("interrupted; the map of " + counted(run.frames, "frame") + " is in '" +
                                output + "', go on with:",
                            arguments.commandWith(values));
}

int makeMap(Arguments& arguments)
{
    std::shared_ptr<CVoxelandMap> map = std::make_shared<CVoxelandMap>();
    const bool resumes = arguments.resume.isSet();
    if (resumes) map = loadMap(arguments.resume.value());
    MapperConfig config(configuration(arguments, resumes ? map.get() : nullptr),
                        MapperConfig::Purpose::mapping,
                        [&](const std::string& left) { arguments.warn(left); });
    if (arguments.dumpConfig.isSet()) {
        const std::string& keys = arguments.dumpConfig.value();
        if (!keys.empty() && keys != "all")
            throw ConfigurationError("--dump-config takes 'all' or nothing, not '" + keys + "'");
        std::cout << (keys.empty() ? "# What users change; --dump-config all prints all keys.\n\n" +
                                         config.commonText()
                                   : config.text());
        return 0;
    }
    if (arguments.checkConfig.isSet()) {
        std::cout << "the configuration is valid\n";
        return 0;
    }
    if (arguments.input.value().empty() || arguments.output.value().empty())
        throw ConfigurationError("give a rawlog with -i and a map to write with -o (see --help)");
    if (arguments.every.value() == 0 || arguments.from.value() > arguments.to.value())
        throw ConfigurationError("--every must be at least 1 and --from not beyond --to");
    const std::string& input = arguments.input.value();
    config.input.trust_paths = arguments.trustPaths.isSet();
    map->setConfig(config);
    if (arguments.exportDir.isSet()) checkExportFolder(arguments.exportDir.value());
    apps::checkOutputs(
        {{arguments.output.value(), arguments.timing.value(), arguments.trace.value()},
         {},
         {arguments.exportDir.value()}},
        {{arguments.poses.value(), arguments.config.value()}, {input}, {}});

    const Run run = mapAndSave(arguments, *map);
    if (arguments.timing.isSet())
        writeAtomically(arguments.timing.value(),
                        [&](std::ostream& out) { run.timing.writeCsv(out); });
    if (run.stoppedBefore) endInterrupted(arguments, run);
    if (map->counts().framesWithoutPredictions == map->counts().frames &&
        map->counts().predictionsWithoutFrame == 0)
        arguments.warn(
            "no frame has predictions, everything is unknown; "
            "they belong in the rawlog or in NAME.instances.rawlog beside it");
    if (arguments.exportDir.isSet()) {
        WrittenFiles written;
        written.add(arguments.output.value());
        exportAll(map->map(), arguments.exportDir.value(), written);
    }
    printSummary(*map, run.timing);
    return 0;
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    if (arguments.listPlugins.isSet()) {
        const Ini ini = configuration(arguments, nullptr);
        listPlugins(std::cout, pluginSearchPath(ini.folder()));
        return 0;
    }
    return makeMap(arguments);
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("rawlog2voxeland", [&] { return run(argc, argv); });
}
