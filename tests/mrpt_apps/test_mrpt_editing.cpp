// SPDX-License-Identifier: BSD-3-Clause
/** MRPT's rawlog-edit keeps our predictions when it knows them. */
#include "SimulatedRobot.h"
#include "files/GzInputFile.h"

#include <algorithm>

using namespace voxeland;
using namespace voxeland::test;

namespace
{
constexpr int FRAMES = 6;

/** The predictions in a rawlog, as they are stored. */
std::vector<std::string> predictionsIn(const std::string& rawlog)
{
    GzInputFile in(rawlog);
    in.keepObjectBytes();
    std::vector<std::string> result;
    while (const auto object = in.readObject())
        if (std::dynamic_pointer_cast<CObservationInstances>(object))
            result.push_back(in.objectBytes());
    return result;
}

/** Once as `rawlog-edit -p libvoxeland.so`, once as `voxeland-run rawlog-edit`. */
class RawlogEdit : public SimulatedRobot, public testing::WithParamInterface<bool>
{
 protected:
    void SetUp() override
    {
        SKIP_WITHOUT("rawlog-edit");
        m_rawlog = simulate("robot", FRAMES, {"--embed", "--images", "embedded"});
    }

    [[nodiscard]] ProgramResult edit(const std::vector<std::string>& arguments) const
    {
        // MRPT 2.5.8 forgets the slash after a rawlog's folder where it names text files.
        std::vector<std::string> all{"-i", "robot.rawlog"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        if (GetParam()) return runMrpt(Way::Launcher, folder(), "rawlog-edit", all);
        all.insert(all.end(), {"-p", voxelandLibrary()});
        return runProgramIn(folder(), "rawlog-edit", all);
    }

    std::string m_rawlog;
};
}  // namespace

TEST_P(RawlogEdit, CountsPredictions)
{
    const auto result = edit({"--info"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("RGBD_instances /      6 /"), std::string::npos) << result.output;
}

TEST_P(RawlogEdit, KeepsPredictionsByteByByte)
{
    const auto before = predictionsIn(m_rawlog);
    ASSERT_EQ(before.size(), FRAMES);
    for (const std::vector<std::string>& operation :
         {std::vector<std::string>{"--keep-label", "RGBD,RGBD_instances,pose"},
          std::vector<std::string>{"--remove-label", "LASER"},
          std::vector<std::string>{"--cut", "--from-index", "0"}})
    {
        auto arguments = operation;
        arguments.insert(arguments.end(), {"-o", path("edited.rawlog"), "--overwrite"});
        const auto result = edit(arguments);
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_TRUE(predictionsIn(path("edited.rawlog")) == before) << operation.front();
    }
}

TEST_P(RawlogEdit, ScansAndPredictionsStayTogetherWhenTimeIsShifted)
{
    const auto result =
        edit({"--remap-timestamps", "1;100", "-o", path("later.rawlog"), "--overwrite"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto map = mapOf(path("later.rawlog"));
    EXPECT_EQ(map->counts().frames, static_cast<uint32_t>(FRAMES));
    EXPECT_EQ(map->counts().framesWithoutPredictions, 0U);
}

TEST_P(RawlogEdit, ImagesMovedToFilesMakeTheSameMap)
{
    const auto result = edit({"--externalize", "-o", path("moved.rawlog"), "--overwrite"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const auto map = mapOf(path("moved.rawlog")), before = mapOf(m_rawlog);
    EXPECT_EQ(map->counts().frames, before->counts().frames);
    EXPECT_EQ(map->counts().opinions, before->counts().opinions);
}

TEST_P(RawlogEdit, ExportsPredictionsAsText)
{
    const auto result = edit({"--export-txt"});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const std::string text = readFile(path("robot_RGBD_instances.txt"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), FRAMES + 1);
    EXPECT_NE(text.find("chair:"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Ways, RawlogEdit, testing::Values(false, true), [](const auto& launcher) {
    return launcher.param ? "Launcher" : "PluginOption";
});
