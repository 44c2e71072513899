// SPDX-License-Identifier: BSD-3-Clause
/** The program rawlog-add-instances, run as a user does. */
#include "support/RunProgram.h"
#include "support/SevenScenes.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace voxeland;
namespace fs = std::filesystem;

namespace
{
class RawlogAddInstances : public testing::Test
{
 protected:
    /** A rawlog of two frames, and a prediction of a category that is not COCO's. */
    void SetUp() override
    {
        for (const char* name : {"frame-000000", "frame-000001"})
            test::writeSevenScenesFrame(m_folder.path() / "seq-01" / name);
        ASSERT_EQ(test::runProgram("rgbd2rawlog",
                                   {"-f", "7scenes", "-i", path("seq-01"), "-o", path("in.rawlog")})
                      .exitCode,
                  0);
        test::writeFile(path("coco.json"),
                        R"([{"image_id": 1, "category_id": 500, "score": 0.5,
                             "segmentation": {"size": [24, 32], "counts": [0, 768]}}])");
        test::writeFile(path("names.csv"), "id,name\n500,robot\n");
    }

    [[nodiscard]] std::string path(const std::string& name) const { return m_folder.file(name); }

    [[nodiscard]] test::ProgramResult add(const std::string& output,
                                          std::vector<std::string> options = {}) const
    {
        for (const std::string& o :
             {std::string("-i"), path("in.rawlog"), std::string("--coco"), path("coco.json"),
              std::string("--categories"), path("names.csv"), std::string("-o"), output})
            options.push_back(o);
        return test::runProgram("rawlog-add-instances", options);
    }

    test::TemporaryFolder m_folder;
};

void expectSentence(const test::ProgramResult& result, int exitCode, const std::string& part)
{
    EXPECT_EQ(result.exitCode, exitCode) << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
}
}  // namespace

TEST_F(RawlogAddInstances, writesASidecar)
{
    const auto result = add(path("out.rawlog"));
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, "frames: 2\npredictions: 1\nwritten: " + path("out.rawlog") +
                                 "\nwritten: " + path("out.instances.rawlog") +
                                 "\nlinked: " + path("out_Images") + ", to the images of " +
                                 path("in.rawlog") + "\n");
    EXPECT_EQ(test::readFile(path("out.rawlog")), test::readFile(path("in.rawlog")));
    EXPECT_TRUE(fs::exists(path("out_Images")));
}

TEST_F(RawlogAddInstances, theOutputMayBeTheInput)
{
    const std::string before = test::readFile(path("in.rawlog"));
    const auto result = add(path("in.rawlog"));
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output,
              "frames: 2\npredictions: 1\nwritten: " + path("in.instances.rawlog") + "\n");
    EXPECT_EQ(test::readFile(path("in.rawlog")), before);
}

TEST_F(RawlogAddInstances, embedsThem)
{
    const auto result = add(path("out.rawlog"), {"--embed"});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_FALSE(fs::exists(path("out.instances.rawlog")));
    expectSentence(test::runProgram("rawlog-add-instances",
                                    {"-i", path("out.rawlog"), "--coco", path("coco.json"),
                                     "--categories", path("names.csv"), "-o", path("o2.rawlog")}),
                   3, "--embed");
}

TEST_F(RawlogAddInstances, aNumberWithoutANameSaysHowToGiveIt)
{
    expectSentence(
        test::runProgram("rawlog-add-instances", {"-i", path("in.rawlog"), "--coco",
                                                  path("coco.json"), "-o", path("out.rawlog")}),
        3, "category_id 500 has no name: give the names with --categories");
}

TEST_F(RawlogAddInstances, aListInNoOrderPointsToTheDataset)
{
    test::writeFile(path("coco.json"), R"({"images": [{"id": 1, "file_name": "b/12.png"},
                                                      {"id": 2, "file_name": "b/11.png"}],
                                           "annotations": []})");
    expectSentence(add(path("out.rawlog")), 3, "rgbd2rawlog --predictions");
    EXPECT_FALSE(fs::exists(path("out.instances.rawlog")));
}

TEST_F(RawlogAddInstances, saysHowImagesWereMatchedAndWhatWasLeftOut)
{
    const std::string good = R"({"image_id": 1, "category_id": 500, "segmentation":
                                 {"size": [24, 32], "counts": [0, 768]}})";
    test::writeFile(path("coco.json"), R"({"images": [{"id": 1, "file_name": "a.png"},
                                                      {"id": 2, "file_name": "b.png"}],
                                           "annotations": [)" +
                                           good +
                                           R"(, {"image_id": 2, "category_id": 500,
                                                 "segmentation": []}]})");
    const auto result = add(path("out.rawlog"));
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_NE(result.output.find("predictions: 1\n"), std::string::npos);
    EXPECT_NE(result.errors.find("in the order of the file's images"), std::string::npos)
        << result.errors;
    EXPECT_NE(result.errors.find(
                  "1 odd entry left out (--strict: an error), the first: " + path("coco.json") +
                  ": prediction 1 (image_id 2): segmentation is empty"),
              std::string::npos)
        << result.errors;
    expectSentence(add(path("strict.rawlog"), {"--strict"}), 3, "segmentation is empty");
    EXPECT_FALSE(fs::exists(path("strict.rawlog")));
    const auto imported = test::runProgram(
        "rgbd2rawlog", {"-f", "7scenes", "-i", path("seq-01"), "-o", path("im.rawlog"),
                        "--predictions", path("coco.json"), "--categories", path("names.csv")});
    EXPECT_EQ(imported.exitCode, 0) << imported.errors;
    EXPECT_NE(imported.errors.find("in the order of the file's images"), std::string::npos)
        << imported.errors;
    EXPECT_EQ(test::readFile(path("im.instances.rawlog")),
              test::readFile(path("out.instances.rawlog")));
}

TEST_F(RawlogAddInstances, aTruncatedRawlogEndsWithThree)
{
    const std::string whole = test::readFile(path("in.rawlog"));
    test::writeFile(path("in.rawlog"), whole.substr(0, whole.size() - 30));
    for (const auto& options : std::vector<std::vector<std::string>>{{}, {"--embed"}})
        expectSentence(add(path("out.rawlog"), options), 3, "cut off");
    EXPECT_FALSE(fs::exists(path("out.rawlog")));
}

TEST_F(RawlogAddInstances, wrongUsageAndUnwritableOutput)
{
    EXPECT_EQ(test::runProgram("rawlog-add-instances", {}).exitCode, 1);
    expectSentence(add(path("out.map")), 1, ".rawlog");
    expectSentence(add(path("no/such/out.rawlog")), 5, "no/such");
}
