// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/SevenScenesReader.h"
#include "support/SevenScenes.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3D.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>

using namespace voxeland;
using voxeland::test::writeSevenScenesFrame;
namespace fs = std::filesystem;

namespace
{
class SevenScenesReaderTest : public testing::Test
{
 protected:
    [[nodiscard]] fs::path frame(int number, const std::string& sequence = "seq-01") const
    {
        std::string digits = std::to_string(number);
        digits.insert(0, 6 - digits.size(), '0');
        return m_folder.path() / sequence / ("frame-" + digits);
    }
    void writeFrames(int n, const std::string& sequence = "seq-01") const
    {
        for (int i = 0; i < n; ++i) writeSevenScenesFrame(frame(i, sequence));
    }
    [[nodiscard]] std::string path(const std::string& name = "") const
    {
        return m_folder.file(name);
    }
    /** Numbers of the frames that can be read. */
    static std::vector<int64_t> readAll(RgbdDatasetReader& reader)
    {
        std::vector<int64_t> numbers;
        for (RgbdRecord record; reader.next(record);) numbers.push_back(reader.frame().number);
        return numbers;
    }

    test::TemporaryFolder m_folder;
};

using Numbers = std::vector<int64_t>;
}  // namespace

TEST_F(SevenScenesReaderTest, readsAFrame)
{
    writeFrames(2);
    cv::Mat depth(24, 32, CV_16U, cv::Scalar(2000));
    depth.at<uint16_t>(0, 0) = 0;
    depth.at<uint16_t>(3, 5) = 65535;
    depth.at<uint16_t>(23, 31) = 65534;
    cv::imwrite(frame(1).string() + ".depth.png", depth);
    test::writeFile(path("camera-intrinsics.txt"), "50 0 16\n0 51 12\n0 0 1\n");
    // Half a metre to the left of the origin, looking along it.
    test::writeFile(frame(1).string() + ".pose.txt", "1 0 0 -0.5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");

    SevenScenesReader reader(path());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(reader.frame().number, 1);
    EXPECT_EQ(reader.frame().image, "seq-01/frame-000001.color.png");

    const auto& scan = *record.scan;
    EXPECT_EQ(scan.sensorLabel, "RGBD");
    EXPECT_NEAR(mrpt::Clock::toDouble(scan.timestamp), 1356998400 + 1.0 / 30, 1e-6);
    EXPECT_TRUE(scan.hasRangeImage && scan.hasIntensityImage && scan.range_is_depth);
    EXPECT_FLOAT_EQ(scan.rangeUnits, 0.001F);
    EXPECT_EQ(scan.rangeImage(1, 1), 2000);
    EXPECT_EQ(scan.rangeImage(0, 0), 0);
    EXPECT_EQ(scan.rangeImage(3, 5), 0);
    EXPECT_EQ(scan.rangeImage(23, 31), 65534);
    EXPECT_EQ(scan.intensityImage.getWidth(), 32U);
    EXPECT_TRUE(scan.doDepthAndIntensityCamerasCoincide());
    for (const auto* camera : {&scan.cameraParams, &scan.cameraParamsIntensity}) {
        EXPECT_EQ(camera->ncols, 32U);
        EXPECT_EQ(camera->nrows, 24U);
        EXPECT_EQ(camera->fx(), 50);
        EXPECT_EQ(camera->fy(), 51);
        EXPECT_EQ(camera->cx(), 16);
        EXPECT_EQ(camera->cy(), 12);
    }
    // One metre in front of the camera; the world's axes are optical ones here.
    const auto p = mrpt::poses::CPose3D(*record.robotPose).composePoint({1, 0, 0});
    EXPECT_NEAR(p.x, -0.5, 1e-9);
    EXPECT_NEAR(p.y, 0, 1e-9);
    EXPECT_NEAR(p.z, 1, 1e-9);
    EXPECT_FALSE(reader.next(record));
}

TEST_F(SevenScenesReaderTest, takesASceneOrASequence)
{
    writeFrames(3, "seq-01");
    writeFrames(2, "seq-02");
    SevenScenesReader scene(path());
    EXPECT_EQ(readAll(scene), (Numbers{0, 1, 2, 3, 4}));
    EXPECT_EQ(scene.frames().back().image, "seq-02/frame-000001.color.png");
    SevenScenesReader sequence(path("seq-02"));
    EXPECT_EQ(readAll(sequence), (Numbers{0, 1}));
    EXPECT_EQ(sequence.frames().back().image, "frame-000001.color.png");
}

TEST_F(SevenScenesReaderTest, intrinsicsMayBeAboveTheSequenceOrMissing)
{
    writeSevenScenesFrame(frame(0), "png", 640, 480);
    const auto focalLength = [](const std::string& folder) {
        SevenScenesReader reader(folder);
        RgbdRecord record;
        EXPECT_TRUE(reader.next(record));
        return record.scan->cameraParams.fx();
    };
    EXPECT_EQ(focalLength(path("seq-01")), 585);
    test::writeFile(path("camera-intrinsics.txt"), "500 0 320\n0 500 240\n0 0 1\n");
    EXPECT_EQ(focalLength(path("seq-01")), 500);
    EXPECT_EQ(focalLength(path("seq-01/")), 500);
    EXPECT_EQ(focalLength(path()), 500);
    test::writeFile(path("camera-intrinsics.txt"), "500 0 16\n");
    EXPECT_THROW(SevenScenesReader(path("seq-01")), InputError);
}

TEST_F(SevenScenesReaderTest, selectsFrames)
{
    writeFrames(10);
    SevenScenesReader reader(path());
    reader.select(2, 8, 3);
    EXPECT_EQ(reader.selected().size(), 3U);
    EXPECT_EQ(readAll(reader), (Numbers{2, 5, 8}));
    EXPECT_THROW(reader.select(0, 9, 0), ConfigurationError);
    EXPECT_THROW(reader.select(5, 4, 1), ConfigurationError);
}

TEST_F(SevenScenesReaderTest, framesThatCannotBeUsedAreSkippedWithTheReason)
{
    writeFrames(7);
    fs::remove(frame(1).string() + ".color.png");
    fs::remove(frame(2).string() + ".depth.png");
    fs::remove(frame(3).string() + ".pose.txt");
    test::writeFile(frame(4).string() + ".pose.txt", "2 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    test::writeFile(frame(5).string() + ".pose.txt", "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    test::writeFile(frame(6).string() + ".pose.txt", "1 0 0 0\n0 1 0 -1.#IND\n0 0 1 0\n0 0 0 1\n");
    SevenScenesReader reader(path());
    EXPECT_EQ(readAll(reader), (Numbers{0}));
    std::vector<std::string> reasons;
    for (const auto& s : reader.skipped()) {
        EXPECT_EQ(s.frame.number, static_cast<int64_t>(reasons.size()) + 1);
        reasons.push_back(s.reason);
    }
    EXPECT_EQ(reasons,
              (std::vector<std::string>{"no colour image", "no depth image", "no pose file",
                                        "pose is not a rigid transform", "pose is not finite",
                                        "pose is not a 4x4 matrix"}));
}

TEST_F(SevenScenesReaderTest, aFrameWithADamagedImageIsLeftOut)
{
    const auto expectReason = [&](const std::string& reason, const std::string& what) {
        SevenScenesReader reader(path());
        EXPECT_EQ(readAll(reader), (Numbers{1, 2})) << what;
        ASSERT_EQ(reader.skipped().size(), 1U) << what;
        EXPECT_EQ(reader.skipped()[0].frame.number, 0) << what;
        EXPECT_EQ(reader.skipped()[0].reason, reason) << what;
        DatasetOptions strict;
        strict.strict = true;
        SevenScenesReader strictReader(path(), strict);
        try {
            RgbdRecord record;
            static_cast<void>(strictReader.next(record));
            ADD_FAILURE() << "no exception for " << what;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("frame-000000.color"), std::string::npos)
                << e.what();
            EXPECT_NE(std::string(e.what()).find(reason), std::string::npos) << e.what();
        }
    };
    writeFrames(3);
    const std::string stem = frame(0).string();
    for (const std::string extension : {".color.png", ".depth.png", ".color.jpg"})
        for (const int percent : {0, 50, 95}) {
            for (const char* old : {".color.png", ".color.jpg"}) fs::remove(stem + old);
            writeSevenScenesFrame(frame(0), extension == ".color.jpg" ? "jpg" : "png");
            const std::string whole = test::readFile(stem + extension);
            test::writeFile(stem + extension,
                            whole.substr(0, whole.size() * static_cast<size_t>(percent) / 100));
            expectReason(
                extension == ".depth.png" ? "depth image is damaged" : "colour image is damaged",
                extension);
        }
    writeSevenScenesFrame(frame(0), "jpg");
    std::string jpeg = test::readFile(stem + ".color.jpg");
    const size_t scan = jpeg.find("\xFF\xDA") + 14;
    std::fill(jpeg.begin() + static_cast<std::ptrdiff_t>(scan), jpeg.end() - 2, '\x7F');
    test::writeFile(stem + ".color.jpg", jpeg);
    expectReason("colour image is damaged", "its bytes, but not its length");
    writeSevenScenesFrame(frame(0), "jpg");
    cv::imwrite(stem + ".depth.png", cv::Mat(24, 32, CV_8U, cv::Scalar(7)));
    expectReason("depth image is not one of 16 bits and one channel", "8 bits");
    cv::imwrite(stem + ".depth.png", cv::Mat(24, 31, CV_16U, cv::Scalar(7)));
    expectReason("images of another size than those of other frames", "31 columns");
    cv::imwrite(stem + ".depth.png", cv::Mat(24, 32, CV_16U, cv::Scalar(0)));
    expectReason("nothing measured in the depth image", "zeros");
    cv::imwrite(stem + ".depth.png", cv::Mat(25, 32, CV_16U, cv::Scalar(7)));
    expectReason("depth image has too many pixels for the camera", "25 rows");
    cv::imwrite(stem + ".depth.png", cv::Mat(24, 32, CV_16U, cv::Scalar(65535)));
    expectReason("nothing measured in the depth image", "all too far");
}

TEST_F(SevenScenesReaderTest, twinsOfFilesThatMacOSMakesAreNoFrames)
{
    writeFrames(2);
    for (const char* name : {"seq-01/._frame-000005.color.png", "seq-01/._frame-000000.pose.txt",
                             "._seq-01", "seq-01/.DS_Store", "seq-01/Thumbs.db", ".DS_Store"})
        test::writeFile(path(name), "no frame");
    fs::create_directory(path("._seq-02"));
    SevenScenesReader reader(path());
    EXPECT_EQ(readAll(reader), (Numbers{0, 1}));
    EXPECT_TRUE(reader.skipped().empty());
}

TEST_F(SevenScenesReaderTest, saysWhatItDidNotFind)
{
    EXPECT_THROW(SevenScenesReader(path("missing")), InputError);
    EXPECT_THROW(openDataset("7scenes", path()), InputError);
    EXPECT_THROW(openDataset("8scenes", path()), ConfigurationError);
    writeFrames(1);
    EXPECT_EQ(openDataset("7scenes", path())->name(), "7-Scenes");
}

TEST_F(SevenScenesReaderTest, realFramesFitTogether)
{
    SKIP_WITHOUT_REDKITCHEN();
    SevenScenesReader reader(test::redkitchen().string());
    EXPECT_EQ(reader.frames().size(), 300U);
    // A wall or a cupboard seen from two places a second apart lies at the same place: the centre
    // of each view, put in the world, is close to what the other view sees there.
    reader.select(0, 30, 30);
    RgbdRecord a, b;
    ASSERT_TRUE(reader.next(a) && reader.next(b));
    const mrpt::poses::CPose3D poseA(*a.robotPose), poseB(*b.robotPose);
    std::vector<double> errors;
    for (int row = 20; row < 460; row += 20)
        for (int column = 20; column < 620; column += 20) {
            const double x = a.scan->rangeImage(row, column) * 0.001;
            if (x == 0) continue;
            const auto world =
                poseA.composePoint({x, (320 - column) * x / 585, (240 - row) * x / 585});
            const auto inB = poseB.inverseComposePoint(world);
            const int u = static_cast<int>(std::lround(320 - 585 * inB.y / inB.x));
            const int v = static_cast<int>(std::lround(240 - 585 * inB.z / inB.x));
            if (inB.x <= 0 || u < 0 || u >= 640 || v < 0 || v >= 480) continue;
            const double seen = b.scan->rangeImage(v, u) * 0.001;
            if (seen > 0) errors.push_back(std::abs(seen - inB.x));
        }
    ASSERT_GT(errors.size(), 100U);
    std::nth_element(errors.begin(), errors.begin() + static_cast<long>(errors.size() / 2),
                     errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.05) << "median [m]";
}
