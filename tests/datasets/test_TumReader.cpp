// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/TumReader.h"
#include "support/Room.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <iomanip>
#include <sstream>

using namespace voxeland;
using test::Room;
namespace fs = std::filesystem;

namespace
{
const PinholeCamera SMALL = {60, 60, 39.5, 29.5, {}};

/** A sequence whose colour and depth images come at different times. */
class TumReaderTest : public testing::Test
{
 protected:
    [[nodiscard]] std::string folder() const { return m_folder.file(m_name); }
    void write(const std::string& file, const std::string& content) const
    {
        fs::create_directories(folder());
        test::writeFile(fs::path(folder()) / file, content);
    }
    /** A line of groundtruth.txt for the camera of the room at a step. */
    static std::string poseLine(const std::string& time, int step)
    {
        const auto m = Room::cameraToWorld(step);
        mrpt::math::CMatrixDouble44 matrix;
        for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = m[static_cast<size_t>(i)];
        mrpt::math::CQuaternionDouble q;
        const mrpt::poses::CPose3D pose(matrix);
        pose.getAsQuaternion(q);
        std::ostringstream line;
        line << std::setprecision(12) << time << " " << pose.x() << " " << pose.y() << " "
             << pose.z() << " " << q.x() << " " << q.y() << " " << q.z() << " " << q.r() << "\n";
        return line.str();
    }
    /** Two frames of the room, at steps 0 and 1. */
    void writeRoom(const PinholeCamera& camera, int width, int height) const
    {
        write("rgb.txt", "# colour\n# file\n100.000 rgb/a.png\n100.033 rgb/b.png\n");
        write("depth.txt", "# depth\n100.010 depth/a.png\n100.040 depth/b.png\n");
        write("groundtruth.txt", "# pose\n" + poseLine("100.010", 0) + poseLine("100.040", 1));
        for (const int step : {0, 1}) {
            const std::string file = step == 0 ? "a.png" : "b.png";
            test::writeImage(fs::path(folder()) / "rgb" / file, test::greyImage(width, height));
            test::writeImage(fs::path(folder()) / "depth" / file,
                             Room::depth(Room::cameraToWorld(step), camera, width, height, 5000));
        }
    }
    [[nodiscard]] DatasetOptions small() const
    {
        DatasetOptions options;
        options.camera = SMALL;
        return options;
    }
    template <typename Error>
    void expectFailure(const std::string& part, const DatasetOptions& options) const
    {
        try {
            const TumReader reader(folder(), options);
            FAIL() << "no error about " << part;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    }

    test::TemporaryFolder m_folder;
    std::string m_name = "rgbd_dataset_freiburg3_room";
};
}  // namespace

TEST_F(TumReaderTest, ReadsMetresPosesAndTheCameraOfFreiburg3)
{
    writeRoom({535.4, 539.2, 320.1, 247.6, {}}, 640, 480);
    TumReader reader(folder());
    RgbdRecord record;
    for (const double time : {100.010, 100.040}) {
        ASSERT_TRUE(reader.next(record));
        EXPECT_NEAR(mrpt::Clock::toDouble(record.scan->timestamp), time, 1e-6);
        EXPECT_LT(test::worstDistanceToWalls(record), 2e-3);
    }
    EXPECT_EQ(reader.frame().image, "rgb/b.png");
    EXPECT_FALSE(reader.next(record));
    EXPECT_EQ(reader.notes().size(), 1U);
}

TEST_F(TumReaderTest, KnowsTheCamerasByTheFoldersName)
{
    for (const auto& [name, fx, k1] :
         {std::tuple("rgbd_dataset_freiburg1_desk", 517.306408, 0.262383),
          std::tuple("fr2_xyz", 520.908620, 0.231222), std::tuple("my_fr3_office", 535.4, 0.0)})
    {
        m_name = name;
        writeRoom({525, 525, 320, 240, {}}, 640, 480);
        TumReader reader(folder() + "/");
        RgbdRecord record;
        ASSERT_TRUE(reader.next(record));
        EXPECT_EQ(record.scan->cameraParams.fx(), fx) << name;
        EXPECT_EQ(record.scan->cameraParams.dist[0], k1) << name;
        EXPECT_EQ(record.scan->cameraParamsIntensity.dist[0], k1) << name;
    }
    m_name = "freiburg12_hall";
    writeRoom(SMALL, 80, 60);
    expectFailure<ConfigurationError>("--intrinsics", {});
    TumReader reader(folder(), small());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_LT(test::worstDistanceToWalls(record), 2e-3);
}

TEST_F(TumReaderTest, PairsEachDepthImageOnceClosestFirst)
{
    writeRoom(SMALL, 80, 60);
    // b and c both want the depth image at 0.040; c is closer. d is 25 ms from any.
    write("rgb.txt", "100.0 rgb/a.png\n100.030 rgb/b.png\n100.045 rgb/c.png\n100.1 rgb/d.png\n");
    write("depth.txt", "100.0 depth/a.png\n100.040 depth/b.png\n100.125 depth/b.png\n");
    write("groundtruth.txt", poseLine("100.0", 0) + poseLine("100.05", 1) + poseLine("100.13", 2));
    test::writeImage(fs::path(folder()) / "rgb/c.png", test::greyImage(80, 60));
    TumReader reader(folder(), small());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(reader.frame().number, 0);
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(reader.frame().number, 2);
    EXPECT_NEAR(mrpt::Clock::toDouble(record.scan->timestamp), 100.040, 1e-6);
    EXPECT_FALSE(reader.next(record));
    ASSERT_EQ(reader.skipped().size(), 2U);
    EXPECT_EQ(reader.skipped().front().reason,
              "no depth image within 20 ms that is not another frame's");
}

TEST_F(TumReaderTest, InterpolatesPosesButNotOverGaps)
{
    writeRoom(SMALL, 80, 60);
    write("groundtruth.txt",
          poseLine("100.000", 0) + poseLine("100.020", 2) + poseLine("100.200", 3));
    TumReader reader(folder(), small());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    const auto expected = Room::cameraToWorld(1);  // half way between 0 and 2
    EXPECT_NEAR(record.robotPose->x, expected[3], 1e-9);
    EXPECT_NEAR(record.robotPose->y, expected[7], 1e-9);
    EXPECT_NEAR(record.robotPose->z, expected[11], 1e-9);
    EXPECT_NEAR(record.robotPose->yaw, 0.52, 1e-9);
    EXPECT_FALSE(reader.next(record));
    ASSERT_EQ(reader.skipped().size(), 1U);
    EXPECT_EQ(reader.skipped().front().reason, "no poses within 0.1 s to interpolate between");
}

TEST_F(TumReaderTest, SaysWhatIsWrong)
{
    expectFailure<InputError>(folder(), {});
    writeRoom(SMALL, 80, 60);
    write("rgb.txt", "100.0\n");
    expectFailure<InputError>("line 1 of", small());
    write("rgb.txt", "nan rgb/a.png\n");
    expectFailure<InputError>("is not 'timestamp file'", small());
    write("rgb.txt", "# nothing\n");
    expectFailure<InputError>("names no image", small());
    fs::remove(fs::path(folder()) / "rgb.txt");
    expectFailure<InputError>("rgb.txt", small());
}

TEST_F(TumReaderTest, LeavesOutFramesWithoutImages)
{
    writeRoom(SMALL, 80, 60);
    fs::remove(fs::path(folder()) / "rgb/a.png");
    fs::remove(fs::path(folder()) / "depth/b.png");
    TumReader reader(folder(), small());
    RgbdRecord record;
    EXPECT_FALSE(reader.next(record));
    ASSERT_EQ(reader.skipped().size(), 2U);
    EXPECT_EQ(reader.skipped()[0].reason, "no colour image");
    EXPECT_EQ(reader.skipped()[1].reason, "no depth image");
}

TEST_F(TumReaderTest, ListsNameOnlyImagesOfTheFolder)
{
    writeRoom(SMALL, 80, 60);
    const std::string outside = m_folder.file("outside.png");
    test::writeImage(outside, test::greyImage(80, 60));
    DatasetOptions trusting = small();
    trusting.trustPaths = true;
    for (const std::string& name :
         {std::string("../outside.png"), outside, std::string("rgb/../../outside.png"),
          std::string("..\\outside.png")})
    {
        write("rgb.txt", "100.000 rgb/a.png\n100.033 " + name + "\n");
        expectFailure<InputError>("--trust-paths", small());
        TumReader reader(folder(), trusting);
        RgbdRecord record;
        EXPECT_TRUE(reader.next(record));
        EXPECT_TRUE(reader.next(record)) << name;
    }
    // A folder of links is a folder that the user made.
    fs::create_symlink(outside, fs::path(folder()) / "rgb" / "c.png");
    write("rgb.txt", "100.000 rgb/a.png\n100.033 rgb/c.png\n");
    TumReader reader(folder(), small());
    RgbdRecord record;
    EXPECT_TRUE(reader.next(record));
    EXPECT_TRUE(reader.next(record));
}
