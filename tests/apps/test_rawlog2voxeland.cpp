// SPDX-License-Identifier: BSD-3-Clause
/** rawlog2voxeland as a user runs it: what it makes, and how it fails. */
#include "files/GzInputFile.h"
#include "support/RunProgram.h"
#include "support/SmallRawlog.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
constexpr const char* EARLIER = "an earlier map";

/** A folder with a rawlog `in.rawlog`, and a file `out.voxeland` of an earlier run. */
class Rawlog2voxeland : public ::testing::Test
{
 protected:
    TemporaryFolder m_folder;

    [[nodiscard]] std::string in() const { return m_folder.file("in.rawlog"); }
    [[nodiscard]] std::string out() const { return m_folder.file("out.voxeland"); }

    void write(const std::vector<SmallFrame>& frames, bool embed = false) const
    {
        writeRawlog(in(), frames, embed);
        writeFile(out(), EARLIER);
    }

    [[nodiscard]] ProgramResult run(std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments = {"-i", in(), "-o", out()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runProgram("rawlog2voxeland", arguments);
    }

    std::string mapMade(const std::string& name, const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments = {"-i", in(), "-o", m_folder.file(name), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = runProgram("rawlog2voxeland", arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return readFile(m_folder.file(name));
    }

    /** One sentence on stderr with all these parts, nothing on stdout, no new file, the earlier
     *  output untouched. */
    void expectFailure(const ProgramResult& result, int exitCode,
                       const std::vector<std::string>& parts) const
    {
        EXPECT_EQ(result.exitCode, exitCode) << result.errors;
        EXPECT_EQ(result.output, "");
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        for (const auto& part : parts)
            EXPECT_NE(result.errors.find(part), std::string::npos) << part << ": " << result.errors;
        EXPECT_TRUE(!fs::exists(out()) || readFile(out()) == EARLIER);
        for (const auto& entry : fs::directory_iterator(m_folder.path())) {
            const std::string name = entry.path().filename().string();
            EXPECT_TRUE(name.rfind("in", 0) == 0 || name == "out.voxeland" ||
                        name.rfind("given", 0) == 0)
                << "left behind: " << name;
        }
    }
};
}  // namespace

TEST_F(Rawlog2voxeland, TakesARawlogOfTheCurrentFolder)
{
    write(smallFrames(3));
    const auto result = runProgramIn(m_folder.path().string(), "rawlog2voxeland",
                                     {"-i", "in.rawlog", "-o", "out.voxeland", "--quiet"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
}

TEST_F(Rawlog2voxeland, MakesAMapThatHoldsItsInstances)
{
    write(smallFrames(12));
    const auto result = run();
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("12 mapped"), std::string::npos) << result.output;
    const auto info = runProgram("voxeland-info", {out(), "--instances"});
    EXPECT_EQ(info.exitCode, 0) << info.errors;
    EXPECT_NE(info.output.find("tv"), std::string::npos) << info.output;
    EXPECT_NE(info.output.find("picture"), std::string::npos) << info.output;
}

TEST_F(Rawlog2voxeland, TheMapDoesNotDependOnTheNumberOfThreads)
{
    write(smallFrames(14));
    const std::string one = mapMade("1.voxeland", {"--set", "voxeland.threads=1"});
    EXPECT_EQ(mapMade("2.voxeland", {"--set", "voxeland.threads=2"}), one);
    EXPECT_EQ(mapMade("3.voxeland", {"--set", "voxeland.threads=3"}), one);
    EXPECT_EQ(mapMade("0.voxeland", {}), one);
}

TEST_F(Rawlog2voxeland, ARunCutInTwoMakesTheSameMap)
{
    for (const bool embed : {false, true}) {
        write(smallFrames(14), embed);
        const std::string whole = mapMade("whole.voxeland", {});
        mapMade("first.voxeland", {"--to", "5"});
        EXPECT_EQ(
            mapMade("both.voxeland", {"--from", "6", "--resume", m_folder.file("first.voxeland")}),
            whole)
            << (embed ? "embedded predictions" : "sidecar");
    }
}

TEST_F(Rawlog2voxeland, FramesOfTheResumedMapCountOnce)
{
    auto frames = smallFrames(14);
    write(frames);
    const std::string whole = mapMade("whole.voxeland", {});
    const std::string first = mapMade("first.voxeland", {"--to", "5"});
    const auto resumed = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--resume", m_folder.file("first.voxeland")});
        return run(options);
    };
    for (const auto& [from, said] : std::vector<std::pair<std::string, std::string>>{
             {"0", "left out 6 frames"}, {"3", "left out 3 frames"}, {"6", ""}})
    {
        const auto result = resumed({"--from", from});
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'),
                  said.empty() ? 0 : 1);
        EXPECT_NE(result.errors.find(said), std::string::npos) << result.errors;
        EXPECT_EQ(readFile(out()), whole) << from;
    }
    EXPECT_NE(resumed({"--to", "5"}).errors.find("left out 6 frames"), std::string::npos);
    EXPECT_EQ(readFile(out()), first) << "nothing is learnt from the same frames";
    for (auto& f : frames) {
        f.scan->timestamp += std::chrono::hours(1);
        f.instances->timestamp += std::chrono::hours(1);
        if (f.pose) f.pose->timestamp += std::chrono::hours(1);
    }
    write(frames);
    EXPECT_EQ(resumed({}).errors, "") << "another rawlog";
    EXPECT_NE(readFile(out()), first);
}

TEST_F(Rawlog2voxeland, EmbeddedPredictionsGiveTheSameMapAsASidecar)
{
    write(smallFrames(8));
    const std::string sidecar = mapMade("a.voxeland", {"--every", "2"});
    fs::remove(m_folder.file("in.instances.rawlog"));
    write(smallFrames(8), true);
    EXPECT_EQ(mapMade("b.voxeland", {"--every", "2"}), sidecar);
}

TEST_F(Rawlog2voxeland, ARawlogWithoutPredictionsStillMaps)
{
    auto frames = smallFrames(4);
    for (auto& f : frames) f.instances = nullptr;
    write(frames);
    fs::remove(m_folder.file("in.instances.rawlog"));
    const auto result = run();
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("4 of them without predictions"), std::string::npos)
        << result.output;
}

TEST_F(Rawlog2voxeland, FramesWithoutAPoseAreSkippedAndCounted)
{
    auto frames = smallFrames(6);
    frames[0].pose = nullptr;
    frames[5].pose->pose.mean.x(NAN);
    write(frames);
    const auto result = run();
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("4 mapped"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("2 left out without pose"), std::string::npos) << result.output;
}

TEST_F(Rawlog2voxeland, PixelsWithoutDepthAreNoObstacle)
{
    auto frames = smallFrames(3);
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column)
            frames[1].scan->rangeImage(row, column) = 0;
    write(frames);
    const auto result = run({"--set", "voxeland.min_depth=0"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.errors.find("1 frame left out"), std::string::npos) << result.errors;
    EXPECT_NE(result.output.find("2 mapped"), std::string::npos) << result.output;
}

TEST_F(Rawlog2voxeland, NothingToMapEndsWith4)
{
    auto frames = smallFrames(3);
    for (auto& f : frames) f.pose = nullptr;
    write(frames);
    expectFailure(run(), 4, {"pose", "--poses"});
    for (auto& f : frames) f.scan = nullptr;
    write(frames);
    expectFailure(run(), 4, {"no CObservation3DRangeScan"});
    write(smallFrames(3));
    expectFailure(run({"--from", "10"}), 4, {"range"});
    expectFailure(run({"--set", "voxeland.depth_sensor_label=front"}), 4,
                  {"depth_sensor_label = front", "'" + smallFrames(1)[0].scan->sensorLabel + "'"});
    expectFailure(run({"--set", "voxeland.pose_sensor_label=gps"}), 4,
                  {"pose_sensor_label = gps", "only of"});
}

TEST_F(Rawlog2voxeland, AMissingOrForeignInputEndsWith3)
{
    writeFile(out(), EARLIER);
    expectFailure(run(), 3, {"in.rawlog"});
    writeFile(in(), "this is no rawlog, but a text of some length");
    expectFailure(run(), 3, {"in.rawlog"});
}

TEST_F(Rawlog2voxeland, ATruncatedRawlogEndsWith3)
{
    write(smallFrames(6));
    const std::string whole = readFile(in());
    writeFile(in(), whole.substr(0, whole.size() * 2 / 3));
    expectFailure(run(), 3, {"in.rawlog", "cut off or damaged"});
}

TEST_F(Rawlog2voxeland, ATruncatedSidecarEndsWith3)
{
    write(smallFrames(6));
    const std::string sidecar = m_folder.file("in.instances.rawlog"), whole = readFile(sidecar);
    writeFile(sidecar, whole.substr(0, whole.size() / 2));
    expectFailure(run(), 3, {"in.instances.rawlog", "cut off or damaged"});
}

TEST_F(Rawlog2voxeland, AMissingDepthImageEndsWith3IfStrict)
{
    auto frames = smallFrames(3);
    fs::create_directories(m_folder.file("in_Images"));
    frames[1].scan->rangeImage_convertToExternalStorage("depth_1.png",
                                                        m_folder.file("in_Images") + "/");
    write(frames);
    EXPECT_EQ(
        runProgram("rawlog2voxeland", {"-i", in(), "-o", m_folder.file("given.voxeland")}).exitCode,
        0);
    for (const auto& image : fs::directory_iterator(m_folder.file("in_Images")))
        fs::remove(image.path());
    expectFailure(run({"--strict"}), 3, {"depth_1", "image"});
    const auto result = run();
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("1 frame left out"), std::string::npos) << result.errors;
    EXPECT_NE(result.output.find("2 mapped"), std::string::npos) << result.output;
}

TEST_F(Rawlog2voxeland, APictureInsideTheRawlogThatIsNoneIsMissedAlone)
{
    auto frames = smallFrames(3);
    for (auto& f : frames) {
        f.scan->hasIntensityImage = true;
        f.scan->intensityImage.resize(COLUMNS, ROWS, mrpt::img::CH_RGB);
    }
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(false);
    write(frames);
    mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
    ASSERT_EQ(run().exitCode, 0);
    const std::string whole = readFile(out());

    std::string objects;
    {
        GzInputFile rawlog(in());
        rawlog.keepObjectBytes();
        while (rawlog.readObject()) objects += rawlog.objectBytes();
    }
    const size_t header = objects.find("\xFF\xD8\xFF");
    ASSERT_NE(header, std::string::npos);
    objects[header] = 0;
    writeFile(in(), objects);
    writeFile(out(), EARLIER);
    expectFailure(run({"--strict"}), 3, {"in.rawlog", "damaged picture"});
    const auto result = run();
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("1 picture of the rawlog damaged"), std::string::npos)
        << result.errors;
    EXPECT_EQ(readFile(out()), whole) << "depth, pose and predictions are there";
}

TEST_F(Rawlog2voxeland, MasksOfAWrongSizeAreLeftOut)
{
    auto frames = smallFrames(3);
    frames[2].instances->imageWidth = 160;
    frames[2].instances->imageHeight = 30;
    for (auto& i : frames[2].instances->instances) i.mask = rectangleMask(1, 1, 5, 5, 160, 30);
    write(frames);
    expectFailure(run({"--strict"}), 3, {"160x30", "80x60", "'camera'"});
    const auto result = run();
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.errors.find("2 predictions of the rawlog left out"), std::string::npos)
        << result.errors;
    EXPECT_NE(result.errors.find("160x30"), std::string::npos) << result.errors;
    EXPECT_NE(result.output.find("3 mapped, 1 of them without predictions"), std::string::npos)
        << result.output;
    frames[0].instances = frames[1].instances = nullptr;
    write(frames);
    expectFailure(run(), 3, {"none of the predictions", "160x30"});
}

TEST_F(Rawlog2voxeland, AnUnknownCategoryIsJustAnotherOne)
{
    auto frames = smallFrames(3);
    for (auto& f : frames) f.instances->instances[0].categories = {{"flux capacitor", 1}};
    write(frames);
    ASSERT_EQ(run().exitCode, 0);
    EXPECT_NE(runProgram("voxeland-info", {out(), "--instances"}).output.find("flux capacitor"),
              std::string::npos);
}

TEST_F(Rawlog2voxeland, WrongConfigurationsEndWith1)
{
    write(smallFrames(2));
    const std::string ini = m_folder.file("given.ini");
    writeFile(ini, "[map]\nresolutoin = 0.1\nprob_hit = 2\n[asociation]\ntau_iou = 0.3\n");
    expectFailure(run({"-c", ini}), 1, {"given.ini", "'resolution'", "prob_hit", "[association]"});
    expectFailure(run({"-c", m_folder.file("given_not.ini")}), 1, {"given_not.ini"});
    expectFailure(run({"--set", "map.resolution"}), 1, {"map.resolution"});
    expectFailure(run({"--set", "voxeland.pose_source=gps"}), 1, {"gps", "robot_pose"});
    expectFailure(
        runProgram("rawlog2voxeland", {"--check-config", "--set", "voxeland.pose_source=gps"}), 1,
        {"gps", "robot_pose"});
    expectFailure(run({"--every", "0"}), 1, {"--every"});
    expectFailure(run({"--every", "-1"}), 1, {"--every", "-1"});
    expectFailure(run({"--to=-1"}), 1, {"--to", "-1"});
    expectFailure(run({"--no-such-option"}), 1, {"no-such-option", "--help"});
    expectFailure(run({"--verbosity", "LOUD"}), 1, {"LOUD"});
    expectFailure(runProgram("rawlog2voxeland", {"-i", in()}), 1, {"-o"});
    expectFailure(runProgram("rawlog2voxeland", {"-i", in(), "-o", ""}), 1, {"-o"});
}

TEST_F(Rawlog2voxeland, MissingPluginsAndClassesEndWith2)
{
    write(smallFrames(2));
    expectFailure(run({"--set", "association.plugin=no_such_plugin"}), 2,
                  {"no_such_plugin", "VOXELAND_PLUGIN_PATH"});
    expectFailure(run({"--set", "association.class=CNoSuchClass"}), 2,
                  {"CNoSuchClass", "CEvidentialAssociation"});
    writeFile(m_folder.file("given.so"), "a text");
    expectFailure(run({"--set", "converter.plugin=" + m_folder.file("given.so")}), 2, {"given.so"});
}

TEST_F(Rawlog2voxeland, UnwritableOutputsEndWith5)
{
    write(smallFrames(2));
    const auto into = [&](const std::string& file) {
        return runProgram("rawlog2voxeland", {"-i", in(), "-o", file});
    };
    expectFailure(into(m_folder.file("missing/folder/out.voxeland")), 5, {"missing/folder"});
    expectFailure(into(m_folder.path().string()), 5, {m_folder.path().string()});
    expectFailure(into("/dev/full"), 5, {"/dev/full"});
}

TEST_F(Rawlog2voxeland, OutputsThatCannotBeWrittenAreNoticedBeforeTheWork)
{
    auto frames = smallFrames(2);
    for (auto& f : frames) f.pose = nullptr;
    write(frames);  // nothing to map: the work would end with 4
    const std::string missing = m_folder.file("missing/file");
    for (const std::string option : {"--timing", "--trace"})
        expectFailure(run({option, missing}), 5, {missing});
    expectFailure(run({"--export-dir", in()}), 5, {"in.rawlog"});
    fs::create_directories(m_folder.file("given/map.ply"));
    expectFailure(run({"--export-dir", m_folder.file("given")}), 5, {"/map.ply"});
    expectFailure(runProgram("rawlog2voxeland", {"-i", in(), "-o", missing}), 5, {missing});
}

TEST_F(Rawlog2voxeland, AMapThatCannotBeResumedEndsWith3)
{
    write(smallFrames(2));
    expectFailure(run({"--resume", m_folder.file("given.voxeland")}), 3, {"given.voxeland"});
    writeFile(m_folder.file("given.voxeland"), "no map");
    expectFailure(run({"--resume", m_folder.file("given.voxeland")}), 3, {"given.voxeland"});
    expectFailure(run({"--resume", in()}), 3, {"in.rawlog", "map"});
    mapMade("given.voxeland", {});
    expectFailure(run({"--resume", m_folder.file("given.voxeland"), "--set", "map.resolution=0.1"}),
                  1, {"resolution"});
}

TEST_F(Rawlog2voxeland, ReadsATrajectoryInsteadOfTheRawlogsPoses)
{
    auto frames = smallFrames(3);
    std::string track = "# timestamp tx ty tz qx qy qz qw\n";
    for (auto& f : frames) {
        f.pose = nullptr;
        track += std::to_string(mrpt::Clock::toDouble(f.scan->timestamp)) + " 0 0 1 0 0 0 1\n";
    }
    write(frames);
    writeFile(m_folder.file("given.tum"), track);
    const auto result = run({"--poses", m_folder.file("given.tum")});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("3 mapped"), std::string::npos) << result.output;

    writeFile(m_folder.file("given.tum"), track + "1004 0 0 1 0 0 0 7\n");
    const auto odd = run({"--poses", m_folder.file("given.tum")});
    EXPECT_EQ(odd.exitCode, 0) << odd.errors;
    EXPECT_NE(odd.errors.find("line 5 of the trajectory"), std::string::npos) << odd.errors;
    writeFile(out(), EARLIER);
    expectFailure(run({"--poses", m_folder.file("given.tum"), "--strict"}), 3,
                  {"given.tum", "line 5"});
}

TEST_F(Rawlog2voxeland, TheDumpedConfigurationIsOneThatItTakes)
{
    write(smallFrames(2));
    const auto dump =
        runProgram("rawlog2voxeland", {"--dump-config", "--set", "map.resolution=0.125"});
    ASSERT_EQ(dump.exitCode, 0) << dump.errors;
    EXPECT_NE(dump.output.find("resolution = 0.125"), std::string::npos);
    EXPECT_EQ(dump.output.find("tau_iou"), std::string::npos);
    const auto all = runProgram("rawlog2voxeland", {"--dump-config", "all"});
    EXPECT_NE(all.output.find("tau_iou"), std::string::npos);
    expectFailure(runProgram("rawlog2voxeland", {"--dump-config", "any"}), 1, {"'all'", "'any'"});
    writeFile(m_folder.file("given.ini"), dump.output);
    EXPECT_EQ(
        runProgram("rawlog2voxeland", {"-c", m_folder.file("given.ini"), "--dump-config"}).output,
        dump.output);
    EXPECT_EQ(runProgram("rawlog2voxeland", {"-c", m_folder.file("given.ini"), "--check-config"})
                  .exitCode,
              0);
    EXPECT_EQ(mapMade("a.voxeland", {"-c", m_folder.file("given.ini")}),
              mapMade("b.voxeland", {"--set", "map.resolution=0.125"}));
}

TEST_F(Rawlog2voxeland, WritesTimingAndExports)
{
    write(smallFrames(4));
    const auto result =
        run({"--timing", m_folder.file("t.csv"), "--export-dir", m_folder.file("pictures")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const std::string csv = readFile(m_folder.file("t.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
    EXPECT_FALSE(fs::is_empty(m_folder.file("pictures")));
}

TEST_F(Rawlog2voxeland, ATraceComesWithTheSameMapOrNotAtAll)
{
    write(smallFrames(8));
    const std::string trace = m_folder.file("trace.jsonl");
    EXPECT_EQ(mapMade("a.voxeland", {"--trace", trace}), mapMade("b.voxeland", {}));
    std::istringstream lines(readFile(trace));
    size_t opinions = 0;
    for (std::string line; std::getline(lines, line);)
        opinions += nlohmann::json::parse(line).contains("opinion") ? 1 : 0;
    EXPECT_EQ(opinions, 16U);

    for (const char* file : {"a.voxeland", "b.voxeland", "trace.jsonl"})
        fs::remove(m_folder.file(file));
    expectFailure(run({"--trace", "/dev/full"}), 5, {"/dev/full"});
    expectFailure(run({"--trace", m_folder.file("missing/trace.jsonl")}), 5, {"missing"});
    const std::string whole = readFile(in());
    writeFile(in(), whole.substr(0, whole.size() * 2 / 3));
    expectFailure(run({"--trace", trace}), 3, {"in.rawlog"});
}

TEST_F(Rawlog2voxeland, PredictionsWithoutAFrameAreCountedTheSameInOneRunAndInTwo)
{
    auto frames = smallFrames(12);
    for (const size_t i : {0U, 6U, 11U}) frames[i].scan = nullptr;
    write(frames);
    const auto result = run();
    EXPECT_NE(result.output.find("predictions of 3 frames not in the rawlog"), std::string::npos)
        << result.output;
    const std::string whole = mapMade("whole.voxeland", {});
    for (const int last : {3, 4, 5}) {
        mapMade("first.voxeland", {"--to", std::to_string(last)});
        EXPECT_EQ(mapMade("both.voxeland", {"--from", std::to_string(last + 1), "--resume",
                                            m_folder.file("first.voxeland")}),
                  whole)
            << last;
    }
}

TEST(Rawlog2voxelandHelp, SaysWhatThereIs)
{
    for (const auto& [option, part] : std::vector<std::pair<std::string, std::string>>{
             {"--help", "--resume"},
             {"--version", "rawlog2voxeland"},
             {"--list-plugins", "CEvidentialAssociation"}})
    {
        const auto result = runProgram("rawlog2voxeland", {option});
        EXPECT_EQ(result.exitCode, 0) << option;
        EXPECT_NE(result.output.find(part), std::string::npos) << result.output;
        EXPECT_EQ(result.errors, "");
    }
}

TEST(Rawlog2voxelandRealData, KitchenFramesMapTheSameWithAnyThreadsAndWhenResumed)
{
    SKIP_WITHOUT_REDKITCHEN();
    const TemporaryFolder folder;
    const std::string rawlog = folder.file("k.rawlog");
    std::string predictions;
    for (const auto& entry : fs::directory_iterator(redkitchen()))
        if (entry.path().extension() == ".json") predictions = entry.path().string();
    const auto imported = runProgram(
        "rgbd2rawlog", {"--format", "7scenes", "--input", redkitchen().string(), "--predictions",
                        predictions, "--output", rawlog, "--every", "8", "--quiet"});
    ASSERT_EQ(imported.exitCode, 0) << imported.errors;
    const auto mapped = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"-i", rawlog, "-o", folder.file(name), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = runProgram("rawlog2voxeland", arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return readFile(folder.file(name));
    };
    const std::string one = mapped("1.voxeland", {"--to", "29", "--set", "voxeland.threads=1"});
    EXPECT_EQ(mapped("2.voxeland", {"--to", "29", "--set", "voxeland.threads=2"}), one);
    mapped("a.voxeland", {"--to", "13"});
    EXPECT_EQ(
        mapped("b.voxeland", {"--from", "14", "--to", "29", "--resume", folder.file("a.voxeland")}),
        one);
    const auto info = runProgram("voxeland-info", {folder.file("1.voxeland"), "--instances"});
    EXPECT_EQ(info.exitCode, 0) << info.errors;
    EXPECT_NE(info.output.find("chair"), std::string::npos) << info.output;
}

TEST_F(Rawlog2voxeland, AnOutputNeverReplacesAnInput)
{
    write(smallFrames(2));
    const std::string rawlog = readFile(in());
    const auto result = runProgram("rawlog2voxeland", {"-i", in(), "-o", in()});
    expectFailure(result, 1, {"in.rawlog", "another file"});
    expectFailure(run({"--timing", m_folder.file("in.instances.rawlog")}), 1,
                  {"in.instances.rawlog"});
    expectFailure(run({"--timing", out()}), 1, {"out.voxeland"});
    EXPECT_EQ(readFile(in()), rawlog);
}

TEST_F(Rawlog2voxeland, LinesThatAreNoIniAreNamed)
{
    write(smallFrames(2));
    const std::string ini = m_folder.file("given.ini");
    writeFile(ini, "# fine\n[map]\nresolution 0.1\n");
    expectFailure(run({"-c", ini}), 1, {"line 3", "given.ini"});
    writeFile(ini, "resolution = 0.1\n");
    expectFailure(run({"-c", ini}), 1, {"'resolution'", "before any [section]"});
    writeFile(ini, "[map] // a comment\nentropy = \\\n  mean\n");
    EXPECT_EQ(run({"-c", ini, "--check-config"}).exitCode, 0);
}

TEST_F(Rawlog2voxeland, WarnsWhenNothingHasPredictions)
{
    auto frames = smallFrames(2);
    for (auto& f : frames) f.instances = nullptr;
    write(frames);
    fs::remove(m_folder.file("in.instances.rawlog"));
    EXPECT_NE(run({"-v", "WARN"}).errors.find("warning: no frame has predictions"),
              std::string::npos);
    EXPECT_EQ(run({"-v", "ERROR"}).errors, "");
}
