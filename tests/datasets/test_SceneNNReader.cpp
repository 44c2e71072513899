// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/SceneNNReader.h"
#include "support/Room.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <sstream>

using namespace voxeland;
using test::Room;
namespace fs = std::filesystem;

namespace
{
const PinholeCamera CAMERA = {60, 60, 39.5, 29.5, {}};

class SceneNNReaderTest : public testing::Test
{
 protected:
    SceneNNReaderTest()
    {
        for (int i = 0; i < 3; ++i) writeFrame(i + 1, i);
        test::writeFile(m_folder.file("trajectory.log"), block(0) + block(1) + block(2));
        test::writeFile(m_folder.file("asus.ini"), "fx 60\nfy 60\ncx 39.5\ncy 29.5\n");
    }
    void writeFrame(int number, int step) const
    {
        const std::string digits = "0000" + std::to_string(number);
        test::writeImage(m_folder.file("image/image" + digits + ".png"), test::greyImage(80, 60));
        test::writeImage(m_folder.file("depth/depth" + digits + ".png"),
                         Room::depth(Room::cameraToWorld(step), CAMERA, 80, 60, 1000));
    }
    static std::string block(int step)
    {
        const std::string id = std::to_string(step);
        return id + " " + id + " " + std::to_string(step + 1) + "\n" +
               test::matrixText(Room::cameraToWorld(step));
    }
    [[nodiscard]] std::string folder() const { return m_folder.path().string(); }
    void expectFailure(const std::string& part, const DatasetOptions& options = {}) const
    {
        try {
            const SceneNNReader reader(folder(), options);
            FAIL() << "no error about " << part;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    }
    void expectAllOnWalls() const
    {
        SceneNNReader reader(folder());
        size_t frames = 0;
        for (RgbdRecord record; reader.next(record); ++frames)
            EXPECT_LT(test::worstDistanceToWalls(record), 2e-3) << reader.frame().number;
        EXPECT_EQ(frames, 3U);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(SceneNNReaderTest, ImageOneHasTheFirstPose)
{
    expectAllOnWalls();
    SceneNNReader reader(folder());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_EQ(reader.frame().number, 1);
    EXPECT_TRUE(reader.notes().empty());
}

TEST_F(SceneNNReaderTest, ImageZeroHasItIfThereIsOne)
{
    for (int i = 0; i < 3; ++i) writeFrame(i, i);
    fs::remove(m_folder.file("image/image00003.png"));
    expectAllOnWalls();
}

TEST_F(SceneNNReaderTest, FindsTheCameraAndOtherNames)
{
    fs::create_directory(m_folder.file("intrinsic"));
    fs::rename(m_folder.file("asus.ini"), m_folder.file("intrinsic/asus.ini"));
    fs::rename(m_folder.file("trajectory.log"), m_folder.file("011_trajectory.log"));
    expectAllOnWalls();
    fs::remove(m_folder.file("intrinsic/asus.ini"));
    EXPECT_EQ(SceneNNReader(folder()).notes().size(), 2U) << "the default camera, scaled";
}

TEST_F(SceneNNReaderTest, SkipsLostTracking)
{
    test::writeFile(m_folder.file("trajectory.log"),
                    block(0) + "1 1 2\n0 0 0 0.03\n0 0 0 3.1\n0 0 0 -1.4\n0 0 0 1\n");
    SceneNNReader reader(folder());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_FALSE(reader.next(record));
    ASSERT_EQ(reader.skipped().size(), 2U);
    EXPECT_EQ(reader.skipped()[0].reason, "pose is not a rigid transform");
    EXPECT_EQ(reader.skipped()[1].reason, "no block in the trajectory");
}

TEST_F(SceneNNReaderTest, TellsOfNumbersThatDoNotCount)
{
    test::writeFile(m_folder.file("trajectory.log"), block(0) + block(2) + block(7));
    EXPECT_EQ(SceneNNReader(folder()).notes().size(), 1U);
}

TEST_F(SceneNNReaderTest, SaysWhatIsWrong)
{
    const std::string blocks = block(0) + block(1);
    test::writeFile(m_folder.file("trajectory.log"), blocks.substr(0, blocks.size() - 20));
    expectFailure("cut off or damaged: block 1");
    test::writeFile(m_folder.file("trajectory.log"), "no numbers");
    expectFailure("is not a trajectory");
    fs::remove(m_folder.file("trajectory.log"));
    expectFailure("no trajectory.log");
    fs::remove_all(m_folder.file("image"));
    expectFailure("image/image00001.png");
    test::writeFile(m_folder.file("011.oni"), "");
    expectFailure("playback NNN.oni FOLDER");
}

TEST_F(SceneNNReaderTest, AnnotatedMeshBecomesPredictions)
{
    // The wall x = 4 m is annotated as vertices 1 cm apart: a sofa up to y = 2.5 m, then wall.
    std::ostringstream vertices;
    int n = 0;
    for (double y = 0.005; y < 5; y += 0.01)
        for (double z = 0.005; z < 3; z += 0.01, ++n)
            vertices << "4 " << y << " " << z << " " << (y < 2.5 ? 7 : 3) << "\n";
    test::writeFile(m_folder.file("011.ply"),
                    "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n) +
                        "\nproperty float x\nproperty float y\nproperty float z\n"
                        "property uint label\nend_header\n" +
                        vertices.str());
    test::writeFile(m_folder.file("011.xml"),
                    R"(<?xml version="1.0"?><annotation>
                       <label id="3" text="wall" nyu_class="wall"/>
                       <label id="7" text="my sofa" nyu_class="sofa"/></annotation>)");
    DatasetOptions options;
    options.annotation = true;
    SceneNNReader reader(folder(), options);
    reader.select(3, 3, 1);
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    ASSERT_EQ(record.instances->instances.size(), 1U);
    const auto& sofa = record.instances->instances.front();
    EXPECT_EQ(sofa.categories, (CategoryDistribution{{"sofa", 1}}));
    EXPECT_EQ(sofa.track, 7);
    // The same by geometry: which pixels of the camera see that part of the wall.
    const auto m = Room::cameraToWorld(2);
    const auto mask = sofa.mask.toBitmap();
    size_t wrong = 0, right = 0;
    for (int v = 0; v < 60; ++v)
        for (int u = 0; u < 80; ++u) {
            const double x = (u - 39.5) / 60, y = (v - 29.5) / 60;
            const double dx = m[0] * x + m[1] * y + m[2], dy = m[4] * x + m[5] * y + m[6],
                         dz = m[8] * x + m[9] * y + m[10];
            const double t = (4 - m[3]) / dx;
            const double py = m[7] + t * dy, pz = m[11] + t * dz;
            const bool expected = t > 0 && py > 0 && py < 2.5 && pz > 0 && pz < 3;
            const bool border = std::abs(py) < 0.05 || std::abs(py - 2.5) < 0.05 ||
                                std::abs(pz) < 0.05 || std::abs(pz - 3) < 0.05;
            if (border) continue;
            const bool set = mask[static_cast<size_t>(v * 80 + u)] != 0;
            (set == expected ? right : wrong) += 1;
        }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(sofa.mask.area(), 100U);
}
