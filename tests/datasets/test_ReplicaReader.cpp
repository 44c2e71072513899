// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/ReplicaReader.h"
#include "support/Room.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

using namespace voxeland;
using test::Room;
namespace fs = std::filesystem;

namespace
{
const PinholeCamera CAMERA = {60, 60, 39.5, 29.5, {}};
const std::string PARAMETERS =
    R"({"camera": {"w": 80, "h": 60, "fx": 60.0, "fy": 60.0, "cx": 39.5, "cy": 29.5, "scale": 6553.5}})";

class ReplicaReaderTest : public testing::Test
{
 protected:
    ReplicaReaderTest()
    {
        std::string trajectory;
        for (int i = 0; i < 3; ++i) {
            const auto pose = Room::cameraToWorld(i);
            const std::string number = "00000" + std::to_string(i);
            trajectory += test::matrixText(pose, 16);
            test::writeImage(scene() / ("results/frame" + number + ".jpg"),
                             test::greyImage(80, 60));
            test::writeImage(scene() / ("results/depth" + number + ".png"),
                             Room::depth(pose, CAMERA, 80, 60, 6553.5));
        }
        test::writeFile(scene() / "traj.txt", trajectory);
        test::writeFile(m_folder.file("cam_params.json"), PARAMETERS);
    }
    [[nodiscard]] fs::path scene() const { return m_folder.path() / "office0"; }
    void expectFailure(const std::string& part) const
    {
        try {
            const ReplicaReader reader(scene().string());
            FAIL() << "no error about " << part;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST_F(ReplicaReaderTest, ReadsMetresAndPoses)
{
    ReplicaReader reader(scene().string());
    RgbdRecord record;
    for (const int step : {0, 1, 2}) {
        ASSERT_TRUE(reader.next(record));
        EXPECT_EQ(reader.frame().number, step);
        EXPECT_LT(test::worstDistanceToWalls(record), 1e-3);
        EXPECT_NEAR(mrpt::Clock::toDouble(record.scan->timestamp), 1546300800 + step / 30.0, 1e-6);
    }
    EXPECT_FALSE(reader.next(record));
    EXPECT_TRUE(reader.notes().empty());
}

TEST_F(ReplicaReaderTest, KnowsTheCameraOfAllScenes)
{
    fs::remove(m_folder.file("cam_params.json"));
    const auto pose = Room::cameraToWorld(0);
    test::writeImage(scene() / "results/frame000000.jpg", test::greyImage(1200, 680));
    test::writeImage(scene() / "results/depth000000.png",
                     Room::depth(pose, {600, 600, 599.5, 339.5, {}}, 1200, 680, 6553.5));
    EXPECT_THROW(ReplicaReader(scene().string()), InputError) << "most images of another camera";
    for (const char* other : {"results/frame000001.jpg", "results/frame000002.jpg"})
        fs::remove(scene() / other);
    ReplicaReader reader(scene().string());
    RgbdRecord record;
    ASSERT_TRUE(reader.next(record));
    EXPECT_LT(test::worstDistanceToWalls(record), 1e-3);
    EXPECT_EQ(reader.notes().size(), 1U);
}

TEST_F(ReplicaReaderTest, SkipsFramesWithoutAValidPose)
{
    test::writeFile(scene() / "traj.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n" +
                                              std::string("nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"));
    ReplicaReader reader(scene().string());
    RgbdRecord record;
    EXPECT_FALSE(reader.next(record));
    ASSERT_EQ(reader.skipped().size(), 3U);
    EXPECT_EQ(reader.skipped()[0].reason, "pose is not a 4x4 matrix");
    EXPECT_EQ(reader.skipped()[1].reason, "pose is not finite");
    EXPECT_EQ(reader.skipped()[2].reason, "no line in traj.txt");
}

TEST_F(ReplicaReaderTest, SaysWhatIsWrong)
{
    test::writeFile(m_folder.file("cam_params.json"), R"({"camera": {"fx": 600}})");
    expectFailure("has no 'camera'");
    test::writeFile(m_folder.file("cam_params.json"), "{");
    expectFailure("not valid JSON");
    for (const char* scale : {"1e300", "1e-300"}) {
        std::string parameters = PARAMETERS;
        parameters.replace(parameters.find("6553.5"), 6, scale);
        test::writeFile(m_folder.file("cam_params.json"), parameters);
        expectFailure("a depth scale of 1e");
    }
    fs::remove(scene() / "traj.txt");
    expectFailure("traj.txt");
    fs::remove_all(scene() / "results");
    expectFailure("results/frame000000.jpg");
}
