// SPDX-License-Identifier: BSD-3-Clause
/** MRPT's mapping programs hold and fill a Voxeland map. */
#include "SimulatedRobot.h"
#include "files/GzInputFile.h"
#include "support/MapBytes.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
constexpr uint32_t FRAMES = 30;

class MrptMapping : public SimulatedRobot, public testing::WithParamInterface<Way>
{
};

/** The last pose in a log of MRPT's mapping programs. \param yawColumn from 0 */
mrpt::math::TPose2D lastPose(const std::string& log, size_t yawColumn)
{
    std::ifstream in(log);
    std::string line, last;
    while (std::getline(in, line)) last = line;
    std::istringstream numbers(last);
    std::vector<double> v;
    for (double number = 0; numbers >> number;) v.push_back(number);
    return {v.at(1), v.at(2), v.at(yawColumn)};
}

double distance(const mrpt::math::TPose2D& a, const mrpt::math::TPose2D& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

/** A shipped INI with another `rawlog_offset`. */
std::string withOffset(const std::string& ini, size_t offset)
{
    std::string text = readFile(mrptConfig(ini));
    const std::string none = "rawlog_offset = 0";
    return text.replace(text.find(none), none.size(), "rawlog_offset = " + std::to_string(offset));
}

/** Depth scans of a rawlog from its object of that number on, the first being 1. */
uint32_t scansFrom(size_t number, const std::string& rawlog)
{
    GzInputFile in(rawlog);
    uint32_t scans = 0;
    size_t read = 0;
    while (const auto object = in.readObject()) {
        if (++read < number) continue;
        const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object);
        const auto isScan =
            std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(object) ||
            (frame && frame->getObservationByClass<mrpt::obs::CObservation3DRangeScan>());
        scans += isScan ? 1 : 0;
    }
    return scans;
}

void expectFilled(const CVoxelandMap& map, uint32_t frames)
{
    EXPECT_EQ(map.counts().frames, frames);
    EXPECT_EQ(map.counts().framesWithoutPredictions, 0U);
    EXPECT_GT(map.map().instances().size(), 20U);
}
}  // namespace

TEST_P(MrptMapping, Observations2MapMakesTheMapThatRawlog2VoxelandMakes)
{
    SKIP_WITHOUT("observations2map");
    const auto rawlog = simulate("robot", FRAMES, {"--embed", "--images", "embedded"});
    const auto simplemap = makeSimplemap(rawlog, "robot.simplemap");
    const auto result = runMrpt(GetParam(), folder(), "observations2map",
                                {mrptConfig("observations2map.ini"), simplemap, "made"});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    const auto map = onlyMapIn(folder());
    expectFilled(*map, FRAMES);
    expectSameMap(*map, *mapOf(rawlog));
    expectSameMap(*map, *mapOf(simplemap));
}

TEST_P(MrptMapping, IcpSlamMapsEveryFrameWhileItFindsItsWay)
{
    SKIP_WITHOUT("icp-slam");
    const auto rawlog = simulate("robot", FRAMES, {"--embed", "--images", "embedded"});
    const auto result =
        runMrpt(GetParam(), folder(), "icp-slam", {mrptConfig("icp-slam.ini"), rawlog});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    expectFilled(*onlyMapIn(path("icp-slam-out")), FRAMES);
    const auto end = lastPose(path("icp-slam-out/log_estimated_path.txt"), 3);
    EXPECT_LT(distance(end, truth("robot").back()), 0.1) << "odometry began at the true pose";
}

TEST_P(MrptMapping, IcpSlamMapsEveryFrameOfSensoryFrames)
{
    SKIP_WITHOUT("icp-slam");
    const auto rawlog =
        simulate("robot", FRAMES, {"--embed", "--images", "embedded", "--sensory-frames"});
    const auto result =
        runMrpt(GetParam(), folder(), "icp-slam", {mrptConfig("icp-slam.ini"), rawlog});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    expectFilled(*onlyMapIn(path("icp-slam-out")), FRAMES);
}

TEST_P(MrptMapping, RbpfSlamMapsEveryFrameInFiveParticles)
{
    SKIP_WITHOUT("rbpf-slam");
    const auto rawlog =
        simulate("robot", 20, {"--embed", "--images", "embedded", "--sensory-frames"});
    const auto result =
        runMrpt(GetParam(), folder(), "rbpf-slam", {mrptConfig("rbpf-slam.ini"), rawlog});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    expectFilled(*onlyMapIn(path("rbpf-slam-out")), 20);
    const auto end = lastPose(path("rbpf-slam-out/log_estimated_path.txt"), 4);
    EXPECT_LT(distance(end, truth("robot").back() - truth("robot").front()), 0.5);
}

TEST_P(MrptMapping, IcpSlamBeginsWhereTheIniSays)
{
    SKIP_WITHOUT("icp-slam");
    constexpr size_t OFFSET = 11;
    writeFile(path("later.ini"), withOffset("icp-slam.ini", OFFSET));
    for (const bool sensoryFrames : {false, true}) {
        std::vector<std::string> options{"--embed", "--images", "embedded"};
        if (sensoryFrames) options.emplace_back("--sensory-frames");
        const auto rawlog = simulate("robot", 10, options);
        const auto result = runMrpt(GetParam(), folder(), "icp-slam", {path("later.ini"), rawlog});
        ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
        const uint32_t left = scansFrom(OFFSET, rawlog);
        EXPECT_TRUE(left > 0 && left < 10) << left;
        EXPECT_EQ(onlyMapIn(path("icp-slam-out"))->counts().frames, left);
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, MrptMapping, testing::Values(Way::Preload, Way::Launcher),
                         [](const auto& way) { return nameOf(way.param); });

using VoxelandRun = SimulatedRobot;

TEST_F(VoxelandRun, FindsPredictionsAndImagesBesideTheRawlog)
{
    const auto inside = simulate("inside", FRAMES, {"--embed"});
    const auto beside = simulate("beside", FRAMES, {});
    for (const auto& [rawlog, where] : {std::pair(inside, "a"), std::pair(beside, "b")}) {
        std::filesystem::create_directory(path(where));
        const auto result =
            runMrpt(Way::Launcher, path(where), "icp-slam", {mrptConfig("icp-slam.ini"), rawlog});
        ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    }
    const auto map = onlyMapIn(path("b/icp-slam-out"));
    expectFilled(*map, FRAMES);
    expectSameMap(*map, *onlyMapIn(path("a/icp-slam-out")));
}

TEST_F(VoxelandRun, PredictionsBesideTheRawlogAreNoEntriesOfIt)
{
    constexpr size_t OFFSET = 23;
    const auto rawlog = simulate("robot", 10, {});
    writeFile(path("later.ini"), withOffset("icp-slam.ini", OFFSET));
    const auto result = runMrpt(Way::Launcher, folder(), "icp-slam", {path("later.ini"), rawlog});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    const auto counts = onlyMapIn(path("icp-slam-out"))->counts();
    EXPECT_EQ(counts.frames, scansFrom(OFFSET, rawlog));
    EXPECT_EQ(counts.framesWithoutPredictions, 0U);
}

TEST_F(VoxelandRun, FindsPredictionsBesideSensoryFrames)
{
    const auto rawlog = simulate("robot", 10, {"--sensory-frames"});
    const auto result =
        runMrpt(Way::Launcher, folder(), "icp-slam", {mrptConfig("icp-slam.ini"), rawlog});
    ASSERT_EQ(result.exitCode, 0) << result.output << result.errors;
    expectFilled(*onlyMapIn(path("icp-slam-out")), 10);
}

TEST_F(VoxelandRun, TellsFailuresByItsExitCode)
{
    const auto rawlog = simulate("robot", 3, {"--embed", "--images", "embedded"});
    const std::string ini = mrptConfig("icp-slam.ini"), good = readFile(ini);
    const auto run = [&](const std::vector<std::string>& arguments) {
        return runProgramIn(folder(), "voxeland-run", arguments);
    };
    const auto expectFailure = [](const ProgramResult& result, int exitCode,
                                  const std::string& part) {
        EXPECT_EQ(result.exitCode, exitCode) << result.errors;
        EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
    };
    expectFailure(run({}), 1, "name a program");
    expectFailure(run({"--nonsense", "icp-slam"}), 1, "nonsense");
    expectFailure(run({"no-such-program"}), 1, "no-such-program");
    expectFailure(run({"icp-slam"}), 1, "Usage");
    expectFailure(run({"icp-slam", "absent.ini", rawlog}), 1, "absent.ini");
    expectFailure(run({"icp-slam", ini, "absent.rawlog"}), 1, "absent.rawlog");

    writeFile(path("key.ini"), good + "[MappingApplication_voxelandMap_00_map]\nresolutio = 1\n");
    expectFailure(run({"icp-slam", path("key.ini"), rawlog}), 1, "did you mean 'resolution'");
    writeFile(path("plugin.ini"),
              good + "[MappingApplication_voxelandMap_00_converter]\nplugin = absent\n");
    expectFailure(run({"icp-slam", path("plugin.ini"), rawlog}), 2, "plugin 'absent'");

    const std::string whole = readFile(rawlog);
    writeFile(path("cut.rawlog"), whole.substr(0, whole.size() / 2));
    expectFailure(run({"icp-slam", ini, path("cut.rawlog")}), 3, "cut off");
    expectFailure(run({"rbpf-slam", mrptConfig("rbpf-slam.ini"), rawlog}), 3, "sensory frames");
}

TEST_F(VoxelandRun, ExplainsItself)
{
    const auto help = runProgram("voxeland-run", {"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const auto* word : {"icp-slam", "rbpf-slam", "pf-localization", "observations2map",
                             "share/config/mrpt", "share/voxeland/config/mrpt", "Exit codes"})
        EXPECT_NE(help.output.find(word), std::string::npos) << word;
    EXPECT_EQ(runProgram("voxeland-run", {"--version"}).exitCode, 0);
}

using Simplemap = SimulatedRobot;

TEST_F(Simplemap, ItsKeyframesPosesHoldWhateverTheRawlogTold)
{
    const auto rawlog = simulate("robot", 10, {"--embed", "--images", "embedded"});
    const auto simplemap = makeSimplemap(rawlog, "robot.simplemap");
    const auto map = mapOf(simplemap);
    EXPECT_EQ(map->counts().frames, 10U);
    for (const auto* source : {"odometry", "actions", "simplemap"})
        expectSameMap(*map,
                      *mapOf(simplemap, {"--set", std::string("voxeland.pose_source=") + source}));
}

TEST_F(Simplemap, ATrajectoryReplacesItsPoses)
{
    const auto rawlog = simulate("robot", 10, {"--embed", "--images", "embedded"});
    const auto simplemap = makeSimplemap(rawlog, "robot.simplemap");
    std::ifstream in(path("robot_truth/trajectory.tum"));
    std::ostringstream raised;
    std::string time, x, y, z, rest;
    while (in >> time >> x >> y >> z && std::getline(in, rest))
        raised << time << " " << x << " " << y << " " << std::stod(z) + 7 << rest << "\n";
    writeFile(path("raised.tum"), raised.str());
    const auto map = mapOf(simplemap, {"--poses", path("raised.tum")});
    expectSameMap(*map, *mapOf(rawlog, {"--poses", path("raised.tum")}));
    EXPECT_FALSE(bytesOf(map->map()) == bytesOf(mapOf(simplemap)->map()));
}

TEST_F(Simplemap, ImagesAndPredictionsMayLieBesideIt)
{
    const auto rawlog = simulate("robot", 10, {});
    const auto simplemap = makeSimplemap(rawlog, "robot.simplemap");
    const auto map = mapOf(simplemap);
    EXPECT_EQ(map->counts().framesWithoutPredictions, 0U);
    expectSameMap(*map, *mapOf(rawlog));
}
