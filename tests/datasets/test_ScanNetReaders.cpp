// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/ScanNetSensReader.h"
#include "support/ScanNetScene.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>

using namespace voxeland;
using test::ScanNetScene;
namespace fs = std::filesystem;

namespace
{
class ScanNetReaders : public testing::Test
{
 protected:
    [[nodiscard]] std::string folder() const { return m_folder.path().string(); }
    [[nodiscard]] std::string sens() const { return m_folder.file("scene0000_00.sens"); }
    void writeSens(const std::string& bytes) const { test::writeFile(sens(), bytes); }
    /** What reading everything complains about. */
    [[nodiscard]] std::string failure() const
    {
        try {
            const auto reader = openDataset("scannet", folder());
            for (RgbdRecord record; reader->next(record);) {
            }
        } catch (const InputError& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
            return e.what();
        }
        return "";
    }
    void expectFailure(const std::string& part) const
    {
        const std::string text = failure();
        EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
    }
    static void expectTwoCameras(const RgbdRecord& record)
    {
        const auto& scan = *record.scan;
        EXPECT_EQ(scan.cameraParams.ncols, 80U);
        EXPECT_EQ(scan.cameraParams.fx(), 60);
        EXPECT_EQ(scan.cameraParams.cy(), 29.5);
        EXPECT_EQ(scan.cameraParamsIntensity.ncols, 120U);
        EXPECT_EQ(scan.cameraParamsIntensity.nrows, 90U);
        EXPECT_EQ(scan.cameraParamsIntensity.fx(), 90);
        EXPECT_EQ(scan.cameraParamsIntensity.cx(), 59.5);
        EXPECT_EQ(scan.intensityImage.getWidth(), 120U);
        EXPECT_EQ(scan.rangeImage.cols(), 80);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(ScanNetReaders, ReadASensFile)
{
    writeSens(ScanNetScene::sensFile(
        {ScanNetScene::sensFrame(0), ScanNetScene::sensFrame(1), ScanNetScene::sensFrame(2)}));
    for (const std::string& path : {sens(), folder()}) {
        const auto reader = openDataset("scannet", path);
        RgbdRecord record;
        for (const int step : {0, 1, 2}) {
            ASSERT_TRUE(reader->next(record));
            EXPECT_EQ(reader->frame().image, "color/" + std::to_string(step) + ".jpg");
            EXPECT_NEAR(mrpt::Clock::toDouble(record.scan->timestamp),
                        1483228800 + 5 + 0.033333 * step, 1e-6);
            EXPECT_LT(test::worstDistanceToWalls(record), 2e-3);
            expectTwoCameras(record);
        }
        EXPECT_FALSE(reader->next(record));
        EXPECT_TRUE(reader->notes().empty());
    }
}

TEST_F(ScanNetReaders, ReadOtherCompressionsAndDepthScales)
{
    auto frame = ScanNetScene::sensFrame(0);
    const cv::Mat depth = ScanNetScene::depth(0) * 2;
    frame.depth.assign(reinterpret_cast<const char*>(depth.data), depth.total() * 2);
    frame.colour.clear();
    for (int i = 0; i < 120 * 90; ++i) frame.colour += "\x01\x02\x03";  // red, green, blue
    writeSens(ScanNetScene::sensFile({frame}, 0, 0, 2000));
    const auto reader = openDataset("scannet", sens());
    RgbdRecord record;
    ASSERT_TRUE(reader->next(record));
    EXPECT_LT(test::worstDistanceToWalls(record), 2e-3);
    EXPECT_EQ(record.scan->intensityImage.asCvMatRef().at<cv::Vec3b>(5, 5), cv::Vec3b(3, 2, 1));
}

TEST_F(ScanNetReaders, SkipFramesWhoseTrackingWasLost)
{
    auto lost = ScanNetScene::sensFrame(0), torn = ScanNetScene::sensFrame(1);
    lost.cameraToWorld.fill(-INFINITY);
    torn.cameraToWorld[0] = 3;
    writeSens(ScanNetScene::sensFile({lost, torn, ScanNetScene::sensFrame(2)}));
    const auto reader = openDataset("scannet", sens());
    RgbdRecord record;
    ASSERT_TRUE(reader->next(record));
    EXPECT_EQ(reader->frame().number, 2);
    ASSERT_EQ(reader->skipped().size(), 2U);
    EXPECT_EQ(reader->skipped()[0].reason, "pose is not finite");
    EXPECT_EQ(reader->skipped()[1].reason, "pose is not a rigid transform");
}

TEST_F(ScanNetReaders, AssumeThirtyHertzWhereTimestampsStandStill)
{
    auto a = ScanNetScene::sensFrame(0), b = ScanNetScene::sensFrame(1);
    a.time = b.time = 0;
    writeSens(ScanNetScene::sensFile({a, b}));
    const auto reader = openDataset("scannet", sens());
    EXPECT_EQ(reader->notes().size(), 1U);
    RgbdRecord record;
    ASSERT_TRUE(reader->next(record) && reader->next(record));
    EXPECT_NEAR(mrpt::Clock::toDouble(record.scan->timestamp), 1483228800 + 1.0 / 30, 1e-6);
}

TEST_F(ScanNetReaders, NoticeTruncatedSensFilesWhereverTheyEnd)
{
    const std::string whole =
        ScanNetScene::sensFile({ScanNetScene::sensFrame(0), ScanNetScene::sensFrame(1)});
    // The last 8 bytes, the number of IMU frames, are not needed.
    for (size_t bytes = 0; bytes < whole.size() - 8; bytes += bytes < 600 ? 7 : 97) {
        writeSens(whole.substr(0, bytes));
        EXPECT_NE(failure().find("is truncated"), std::string::npos) << bytes << " " << failure();
    }
    writeSens(whole.substr(0, whole.size() - 8));
    EXPECT_EQ(failure(), "");
}

TEST_F(ScanNetReaders, NameWhatIsWrongInASensFile)
{
    std::string bytes = ScanNetScene::sensFile({ScanNetScene::sensFrame(0)});
    bytes[0] = 3;
    writeSens(bytes);
    expectFailure("version 4 (it begins with 3)");
    writeSens(ScanNetScene::sensFile({}));
    expectFailure("holds no frames");
    writeSens(ScanNetScene::sensFile({ScanNetScene::sensFrame(0)}, 2, 2));
    expectFailure("depth images of compression 2");
    writeSens(ScanNetScene::sensFile({ScanNetScene::sensFrame(0)}, 7, 1));
    expectFailure("colour images of compression 7");
    writeSens(ScanNetScene::sensFile({ScanNetScene::sensFrame(0)}, 2, 1, 0));
    expectFailure("no valid depth scale");
    const auto expectSkipped = [&](const std::string& reason) {
        const auto reader = openDataset("scannet", sens());
        RgbdRecord record;
        EXPECT_FALSE(reader->next(record));
        ASSERT_EQ(reader->skipped().size(), 1U);
        EXPECT_EQ(reader->skipped()[0].reason, reason);
    };
    auto frame = ScanNetScene::sensFrame(0);
    frame.depth[frame.depth.size() / 2] = static_cast<char>(~frame.depth[frame.depth.size() / 2]);
    writeSens(ScanNetScene::sensFile({frame}));
    expectSkipped("depth image is damaged or of another size");
    frame = ScanNetScene::sensFrame(0);
    frame.colour.resize(frame.colour.size() / 2);
    writeSens(ScanNetScene::sensFile({frame}));
    expectSkipped("colour image is damaged");
}

TEST_F(ScanNetReaders, ReadAnExtractedScene)
{
    ScanNetScene::writeFolder(folder(), 12);
    test::writeFile(m_folder.file("pose/1.txt"),
                    "-inf -inf -inf -inf\n-inf -inf -inf -inf\n"
                    "-inf -inf -inf -inf\n-inf -inf -inf -inf\n");
    fs::remove(m_folder.file("pose/2.txt"));
    fs::remove(m_folder.file("depth/3.png"));
    const auto reader = openDataset("scannet", folder());
    std::vector<int64_t> numbers;
    for (RgbdRecord record; reader->next(record);) {
        numbers.push_back(reader->frame().number);
        EXPECT_LT(test::worstDistanceToWalls(record), 2e-3);
        expectTwoCameras(record);
    }
    EXPECT_EQ(numbers, (std::vector<int64_t>{0, 4, 5, 6, 7, 8, 9, 10, 11}));
    ASSERT_EQ(reader->skipped().size(), 3U);
    EXPECT_EQ(reader->skipped()[0].reason, "pose is not finite");
    EXPECT_EQ(reader->skipped()[1].reason, "no pose file");
    EXPECT_EQ(reader->skipped()[2].reason, "no depth image");
}

TEST_F(ScanNetReaders, FollowLinks)
{
    ScanNetScene::writeFolder(m_folder.path() / "elsewhere", 1);
    for (const std::string name : {"color", "depth", "pose", "intrinsic"}) {
        const fs::path target = m_folder.path() / "elsewhere" / name;
        fs::create_directories(m_folder.path() / "linked" / name);
        for (const auto& entry : fs::directory_iterator(target))
            fs::create_symlink(entry.path(), m_folder.path() / "linked" / name /
                                                 ("0" + entry.path().filename().string()));
    }
    fs::remove_all(m_folder.path() / "linked" / "intrinsic");
    fs::create_directory_symlink(m_folder.path() / "elsewhere/intrinsic",
                                 m_folder.path() / "linked/intrinsic");
    RgbdRecord record;
    EXPECT_TRUE(openDataset("scannet", m_folder.file("linked"))->next(record));
}

TEST_F(ScanNetReaders, NameWhatIsWrongInAFolder)
{
    expectFailure("neither a .sens file nor color/0.jpg");
    ScanNetScene::writeFolder(folder(), 1);
    test::writeImage(m_folder.file("color/0.jpg"), test::greyImage(40, 30));
    expectFailure("but their camera is centred at (60, 45)");
    test::writeFile(m_folder.file("intrinsic/intrinsic_depth.txt"), "1 2 3\n");
    expectFailure("intrinsic_depth.txt");
}

TEST_F(ScanNetReaders, AnnotationBecomesPredictions)
{
    ScanNetScene::writeFolder(folder(), 2);
    ScanNetScene::writeAnnotation(folder(), 0);
    DatasetOptions options;
    options.annotation = true;
    const auto reader = openDataset("scannet", folder(), options);
    RgbdRecord record;
    ASSERT_TRUE(reader->next(record));
    const auto& predictions = *record.instances;
    EXPECT_EQ(predictions.timestamp, record.scan->timestamp);
    EXPECT_EQ(predictions.imageWidth, 120);
    EXPECT_EQ(predictions.imageHeight, 90);
    ASSERT_EQ(predictions.instances.size(), 1U) << "the wall is no object";
    const auto& table = predictions.instances.front();
    EXPECT_EQ(table.categories, (CategoryDistribution{{"table", 1}}));
    EXPECT_EQ(table.track, 1);
    EXPECT_EQ(table.score, 1);
    EXPECT_EQ(table.mask.area(), 60U * 90U);
    EXPECT_EQ(table.box.width, 60);
    EXPECT_FALSE(reader->next(record));
    ASSERT_EQ(reader->skipped().size(), 1U);
    EXPECT_EQ(reader->skipped()[0].reason, "no annotation");
}

TEST_F(ScanNetReaders, AnnotationGoesWithASensFileToo)
{
    writeSens(ScanNetScene::sensFile({ScanNetScene::sensFrame(0)}));
    ScanNetScene::writeAnnotation(folder(), 0);
    DatasetOptions options;
    options.annotation = true;
    RgbdRecord record;
    ASSERT_TRUE(openDataset("scannet", sens(), options)->next(record));
    EXPECT_EQ(record.instances->instances.size(), 1U);
}

TEST_F(ScanNetReaders, NameWhatIsWrongWithTheAnnotation)
{
    ScanNetScene::writeFolder(folder(), 1);
    const auto failureOf = [&] {
        DatasetOptions options;
        options.annotation = true;
        try {
            RgbdRecord record;
            static_cast<void>(openDataset("scannet", folder(), options)->next(record));
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_NE(failureOf().find("instance-filt"), std::string::npos) << failureOf();
    ScanNetScene::writeAnnotation(folder(), 0);
    EXPECT_EQ(failureOf(), "");
    test::writeImage(m_folder.file("label-filt/0.png"), cv::Mat(60, 80, CV_16U, cv::Scalar(1)));
    EXPECT_NE(failureOf().find("is not of the size"), std::string::npos) << failureOf();
    test::writeFile(m_folder.file("scannetv2-labels.combined.tsv"), "id\traw_category\n");
    EXPECT_NE(failureOf().find("no column 'nyu40class'"), std::string::npos) << failureOf();
    fs::remove(m_folder.file("scannetv2-labels.combined.tsv"));
    EXPECT_NE(failureOf().find("there is no scannetv2-labels.combined.tsv"), std::string::npos);
}
