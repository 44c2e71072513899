// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/SimulationRun.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"
#include "voxeland/simulation/Simulator.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <map>

using namespace voxeland;
using namespace voxeland::simulation;

namespace
{
SimulationOptions small(uint64_t seed)
{
    SimulationOptions options;
    options.seed = seed;
    options.scene.rooms = 1;
    options.camera.width = 160;
    options.camera.height = 120;
    options.camera.frames = 8;
    options.groundTruthSpacing = 0.05F;
    return options;
}

/** Contents of all files of a run, by name. */
std::map<std::string, std::string> filesOf(const SimulationOptions& options, unsigned threads)
{
    const test::TemporaryFolder folder;
    SimulationOutput output;
    output.rawlog = folder.file("sim.rawlog");
    output.groundTruthFolder = folder.file("truth");
    output.rawlogOptions.comment = "a test";
    output.threads = threads;
    runSimulation(options, output, [](size_t) {});
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(folder.path()).string()] =
                test::readFile(entry.path());
    return files;
}
}  // namespace

TEST(Simulator, SameSeedSameBytesWhateverTheThreads)
{
    const auto once = filesOf(small(1), 1), again = filesOf(small(1), 3);
    EXPECT_TRUE(once == again);
    for (const auto* name : {"sim.rawlog", "sim.instances.rawlog", "truth/ground_truth.ply",
                             "truth/categories.csv", "truth/objects.csv", "truth/trajectory.tum"})
        EXPECT_EQ(once.count(name), 1U) << name;
    const auto other = filesOf(small(2), 1);
    EXPECT_NE(once.at("sim.instances.rawlog"), other.at("sim.instances.rawlog"));
    EXPECT_NE(once.at("truth/objects.csv"), other.at("truth/objects.csv"));
}

TEST(Simulator, TheDetectorDoesNotChangeTheApartmentOrTheImages)
{
    SimulationOptions hard = small(1);
    hard.detector = DetectorOptions::preset("hard");
    const auto a = Simulator(small(1)).frame(3), b = Simulator(hard).frame(3);
    EXPECT_EQ(a.exact.bgr, b.exact.bgr);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.truePose, b.truePose);
}

TEST(Simulator, RecordsAreCompleteMrptObservations)
{
    SimulationOptions options = small(1);
    options.drift.enabled = true;
    const Simulator simulator(options);
    const auto frame = simulator.frame(5);
    const auto record = simulator.record(frame);
    const auto& scan = *record.scan;
    EXPECT_EQ(scan.sensorLabel, "RGBD");
    EXPECT_EQ(record.instances->sensorLabel, "RGBD_instances");
    EXPECT_EQ(scan.timestamp, record.instances->timestamp);
    EXPECT_EQ(scan.rangeImage.rows(), 120);
    EXPECT_EQ(scan.rangeImage.cols(), 160);
    EXPECT_EQ(scan.rangeImage(70, 33), frame.depth[70 * 160 + 33]);
    EXPECT_EQ(scan.intensityImage.at<uint8_t>(33, 70, 2), frame.exact.bgr[3 * (70 * 160 + 33) + 2]);
    EXPECT_NEAR(scan.cameraParams.fx(), 131.25, 1e-9);
    EXPECT_NEAR(scan.cameraParamsIntensity.cx(), 79.5, 1e-9);
    EXPECT_EQ(record.instances->imageWidth, 160);
    EXPECT_EQ(*record.robotPose, frame.reported.pose);
    EXPECT_NE(frame.reported.pose, frame.truePose);
    const auto step = scan.timestamp - simulator.frame(4).timestamp;
    EXPECT_NEAR(
        mrpt::Clock::toDouble(scan.timestamp) - mrpt::Clock::toDouble(scan.timestamp - step),
        1 / 30.0, 1e-5);
}

TEST(Simulator, DepthBecomesPointsOnTheTrueSurfaces)
{
    SimulationOptions options = small(1);
    options.depth.enabled = false;
    const Simulator simulator(options);
    const auto frame = simulator.frame(2);
    const auto record = simulator.record(frame);
    const mrpt::poses::CPose3D pose(*record.robotPose);
    const auto& scan = *record.scan;
    for (int row = 3; row < 120; row += 13)
        for (int column = 2; column < 160; column += 11) {
            const double z = scan.rangeImage(row, column) * 0.001;
            const mrpt::math::TPoint3D local(
                z, (scan.cameraParams.cx() - column) * z / scan.cameraParams.fx(),
                (scan.cameraParams.cy() - row) * z / scan.cameraParams.fy());
            const Vector3 point = pose.composePoint(local).cast<float>();
            bool onSurface = false;
            for (const auto& part : simulator.scene().parts())
                onSurface |=
                    part.solid.contains(point, -0.003F) && !part.solid.contains(point, 0.003F);
            EXPECT_TRUE(onSurface) << row << " " << column;
        }
}

TEST(Simulator, ARobotCarriesTheSameCameraAlongTheSameWay)
{
    SimulationOptions options = small(1);
    const Simulator without(options);
    options.robot.enabled = true;
    const Simulator simulator(options);
    const auto frame = simulator.frame(5), alone = without.frame(5);
    EXPECT_EQ(frame.truePose, alone.truePose);
    EXPECT_TRUE(frame.depth == alone.depth);
    const auto record = simulator.record(frame);
    const mrpt::math::TPose3D& robot = *record.robotPose;
    EXPECT_EQ(robot,
              mrpt::math::TPose3D(alone.truePose.x, alone.truePose.y, 0, alone.truePose.yaw, 0, 0));
    const auto camera = mrpt::poses::CPose3D(robot) + record.scan->sensorPose;
    EXPECT_NEAR((camera - mrpt::poses::CPose3D(frame.truePose)).norm(), 0, 1e-9);
    EXPECT_NEAR(camera.pitch(), frame.truePose.pitch, 1e-9);
    EXPECT_NEAR(camera.roll(), frame.truePose.roll, 1e-9);
    EXPECT_TRUE(without.record(alone).others.empty());
}

TEST(Simulator, ARobotsLaserHitsTrueSurfacesAndItsOdometryDriftsAway)
{
    SimulationOptions options = small(1);
    options.robot.enabled = true;
    options.robot.laserSigma = 0;
    const Simulator simulator(options);
    const auto record = simulator.record(simulator.frame(6));
    ASSERT_EQ(record.others.size(), 2U);
    const auto odometry =
        std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(record.others[0]);
    ASSERT_TRUE(odometry);
    const double drift =
        odometry->odometry.distanceTo(mrpt::poses::CPose2D(mrpt::math::TPose2D(*record.robotPose)));
    EXPECT_GT(drift, 0);
    EXPECT_LT(drift, 0.5);

    const auto laser =
        std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(record.others[1]);
    ASSERT_TRUE(laser);
    mrpt::maps::CSimplePointsMap points;
    points.insertionOptions.minDistBetweenLaserPoints = 0;
    points.loadFromRangeScan(*laser, mrpt::poses::CPose3D(*record.robotPose));
    EXPECT_GT(points.size(), 500U);
    for (size_t i = 0; i < points.size(); i += 7) {
        mrpt::math::TPoint3D at;
        points.getPoint(i, at);
        const Vector3 point = at.cast<float>();
        bool onSurface = false;
        for (const auto& part : simulator.scene().parts())
            onSurface |= part.solid.contains(point, -0.001F) && !part.solid.contains(point, 0.001F);
        EXPECT_TRUE(onSurface) << i;
    }
}

TEST(Simulator, RefusesNonsense)
{
    SimulationOptions options = small(1);
    options.scene.rooms = 4;
    EXPECT_THROW(Simulator{options}, ConfigurationError);
    options = small(1);
    options.camera.frames = 0;
    EXPECT_THROW(Simulator{options}, ConfigurationError);
}
