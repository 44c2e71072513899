// SPDX-License-Identifier: BSD-3-Clause
/** Maps straight from images, as a user makes them: with the shipped INI and a real network. */
#include "support/RunProgram.h"
#include "support/TestFiles.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <gtest/gtest.h>

using namespace voxeland;
using namespace voxeland::test;
namespace fs = std::filesystem;

namespace
{
/** One frame in ten: enough to see every object several times. */
const std::vector<std::string> SOME_FRAMES = {"--every", "10"};

class Networks : public testing::Test
{
 protected:
    /** Makes a rawlog of the real frames. */
    void makeRawlog(const std::string& name, std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments = {
            "-f", "7scenes", "-i", redkitchen().string(), "-o", m_folder.file(name), "--quiet"};
        append(arguments, more);
        append(arguments, SOME_FRAMES);
        const auto made = runProgram("rgbd2rawlog", arguments);
        ASSERT_EQ(made.exitCode, 0) << made.errors;
    }

    /** Maps a rawlog and gives what the program said. */
    std::string map(const std::string& rawlog, const std::string& map,
                    const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments = {"-i", m_folder.file(rawlog), "-o", m_folder.file(map),
                                              "--quiet"};
        append(arguments, more);
        const auto made = runProgram("rawlog2voxeland", arguments);
        EXPECT_EQ(made.exitCode, 0) << made.errors;
        EXPECT_EQ(made.errors, "");
        return made.output;
    }

    [[nodiscard]] std::vector<InstanceSummary> instancesOf(const std::string& map) const
    {
        return summarizeInstances(loadMap(m_folder.file(map))->map());
    }

    [[nodiscard]] static std::string setModel()
    {
        return "converter.model=" +
               (redkitchen().parent_path() / "models" / "yolov8n-seg.onnx").string();
    }

    static void append(std::vector<std::string>& arguments, const std::vector<std::string>& more)
    {
        arguments.insert(arguments.end(), more.begin(), more.end());
    }

    TemporaryFolder m_folder;
};

void expectSameObjects(const std::vector<InstanceSummary>& found,
                       const std::vector<InstanceSummary>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE("instance " + std::to_string(expected[i].id));
        EXPECT_EQ(found[i].id, expected[i].id);
        EXPECT_EQ(found[i].category(), expected[i].category());
        EXPECT_NEAR(found[i].probability(), expected[i].probability(), 0.005);
        EXPECT_NEAR(found[i].entropy, expected[i].entropy, 0.005);
        EXPECT_EQ(found[i].observations, expected[i].observations);
        EXPECT_NEAR(found[i].voxels, expected[i].voxels, 2 + 0.01 * expected[i].voxels);
        EXPECT_LT((found[i].centroid - expected[i].centroid).norm(), 0.05);
    }
}
}  // namespace

TEST_F(Networks, imagesAloneGiveTheMapThatRecordedPredictionsGive)
{
    SKIP_WITHOUT_REDKITCHEN();
    makeRawlog("bare.rawlog");
    makeRawlog("recorded.rawlog",
               {"--predictions", (redkitchen() / "predictions_coco.json").string()});
    const std::string summary =
        map("bare.rawlog", "bare.voxeland", {"-c", VOXELAND_YOLOV8_INI, "--set", setModel()});
    EXPECT_NE(summary.find("30 mapped, 0 of them without predictions"), std::string::npos);
    EXPECT_NE(summary.find("Elapsed time [ms]\n  detection "), std::string::npos) << summary;
    const std::string recordedSummary = map("recorded.rawlog", "recorded.voxeland");
    EXPECT_EQ(recordedSummary.find("Elapsed"), std::string::npos) << recordedSummary;
    const auto expected = instancesOf("recorded.voxeland");
    EXPECT_GE(expected.size(), 5u);
    expectSameObjects(instancesOf("bare.voxeland"), expected);
}

TEST_F(Networks, predictionsMadeBeforehandGiveTheVeryMapOfTheNetwork)
{
    SKIP_WITHOUT_REDKITCHEN();
    makeRawlog("bare.rawlog", {"--to", "59"});
    const std::string rawlog = m_folder.file("bare.rawlog");
    map("bare.rawlog", "direct.voxeland", {"-c", VOXELAND_YOLOV8_INI, "--set", setModel()});
    const auto added =
        runProgram("rawlog-add-instances",
                   {"-i", rawlog, "-o", rawlog, "--dnn", VOXELAND_YOLOV8_INI, "--set", setModel()});
    ASSERT_EQ(added.exitCode, 0) << added.errors;
    EXPECT_EQ(added.output.find("frames: 6\n"), 0u) << added.output;
    map("bare.rawlog", "added.voxeland");
    const auto direct = instancesOf("direct.voxeland"), recorded = instancesOf("added.voxeland");
    ASSERT_EQ(direct.size(), recorded.size());
    for (size_t i = 0; i < direct.size(); ++i) {
        EXPECT_EQ(direct[i].voxels, recorded[i].voxels);
        EXPECT_EQ(direct[i].entropy, recorded[i].entropy);
    }
}

TEST_F(Networks, aFrameWithoutItsColourImageIsLeftOutAndTold)
{
    SKIP_WITHOUT_REDKITCHEN();
    makeRawlog("in.rawlog", {"--to", "29"});
    const std::string rawlog = m_folder.file("in.rawlog");
    size_t images = 0;
    for (const auto& entry : fs::directory_iterator(m_folder.path() / "in_Images"))
        if (const auto& path = entry.path();
            path.extension() == ".jpg" || path.string().find("olor") != std::string::npos)
            if (images++ == 0) fs::remove(path);
    ASSERT_EQ(images, 3U);
    const std::vector<std::string> network = {"--set", setModel()};
    for (const bool strict : {false, true}) {
        std::vector<std::string> mapping = {"-i",     rawlog,
                                            "-o",     m_folder.file("out.voxeland"),
                                            "-c",     VOXELAND_YOLOV8_INI,
                                            "--quiet"},
                                 adding = {"-i",     rawlog,
                                           "-o",     m_folder.file("out.rawlog"),
                                           "--dnn",  VOXELAND_YOLOV8_INI,
                                           "--quiet"};
        if (strict) mapping.push_back("--strict");
        if (strict) adding.push_back("--strict");
        append(mapping, network);
        append(adding, network);
        const auto mapped = runProgram("rawlog2voxeland", mapping);
        EXPECT_EQ(mapped.exitCode, strict ? 3 : 0) << mapped.errors;
        const auto added = runProgram("rawlog-add-instances", adding);
        EXPECT_EQ(added.exitCode, strict ? 3 : 0) << added.errors;
        if (!strict) {
            EXPECT_NE(mapped.output.find("2 mapped"), std::string::npos) << mapped.output;
        }
        for (const std::string& errors : {mapped.errors, added.errors}) {
            EXPECT_NE(errors.find("the colour image of frame"), std::string::npos) << errors;
            EXPECT_EQ(errors.find("1 frame left out") != std::string::npos, !strict) << errors;
        }
    }
}

TEST_F(Networks, aConverterThatMakesNoPredictionsIsNamed)
{
    writeFile(m_folder.file("c.ini"), "[converter]\nplugin = recorded_instances\n");
    const auto result = runProgram(
        "rawlog-add-instances",
        {"-i", "in.rawlog", "-o", m_folder.file("out.rawlog"), "--dnn", m_folder.file("c.ini")});
    EXPECT_EQ(result.exitCode, 1) << result.errors;
    EXPECT_NE(result.errors.find("makes no predictions"), std::string::npos) << result.errors;
    EXPECT_EQ(runProgram("rawlog-add-instances", {"-i", "in.rawlog", "-o", "out.rawlog"}).exitCode,
              1);
}
