// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Simulator.h"

#include "Apartment.h"
#include "DepthNoise.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3D.h>

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
constexpr auto SENSOR = "RGBD";
constexpr double START_TIME = 1735689600;  //!< 2025-01-01 00:00 UTC [s]

/** What random numbers are for: changing one setting does not change all the rest. */
enum Stream : uint64_t
{
    FURNITURE,
    PATH,
    DRIFT,
    RECOGNITION,
    DEPTH,
    DETECTION,
    ODOMETRY,
    LASER,
    JITTER
};

const SimulationOptions& checked(const SimulationOptions& options)
{
    options.check();
    return options;
}

/** The poses on the floor below, level, of a robot that carries the camera. */
std::vector<mrpt::math::TPose3D> carriers(const std::vector<mrpt::math::TPose3D>& cameras)
{
    std::vector<mrpt::math::TPose3D> result;
    for (const auto& camera : cameras) result.emplace_back(camera.x, camera.y, 0, camera.yaw, 0, 0);
    return result;
}

/** Wheels know neither heights nor their own errors. */
std::vector<mrpt::math::TPose2D> onFloor(const std::vector<ReportedPose>& poses)
{
    std::vector<mrpt::math::TPose2D> result;
    for (const ReportedPose& p : poses) result.emplace_back(p.pose);
    return result;
}

mrpt::img::TCamera mrptCamera(const RenderCamera& camera)
{
    mrpt::img::TCamera result;
    result.ncols = static_cast<uint32_t>(camera.width);
    result.nrows = static_cast<uint32_t>(camera.height);
    result.setIntrinsicParamsFromValues(camera.focal, camera.focal, camera.cx, camera.cy);
    return result;
}
}  // namespace

Simulator::Simulator(const SimulationOptions& o)
    : m_options(checked(o)),
      m_scene(makeApartment(o.scene, Random(o.seed, FURNITURE))),
      m_camera(o.camera),
      m_truePoses(CameraPath(m_scene, o.camera, Random(o.seed, PATH)).poses()),
      m_robotPoses(o.robot.enabled ? carriers(m_truePoses) : m_truePoses),
      m_reportedPoses(jittering(drifting(m_robotPoses, o.drift, Random(o.seed, DRIFT)), o.jitter,
                                Random(o.seed, JITTER))),
      m_odometry(onFloor(drifting(m_robotPoses, o.robot.odometry, Random(o.seed, ODOMETRY)))),
      m_renderer(m_scene, m_camera),
      m_laser(m_scene, o.robot),
      m_detector(m_scene, m_camera, o.detector, Random(o.seed, RECOGNITION))
{
}

SimulatedFrame Simulator::frame(size_t index) const
{
    SimulatedFrame frame;
    const double time = START_TIME + static_cast<double>(index) / m_options.camera.frameRate;
    frame.timestamp = mrpt::Clock::fromDouble(time);
    frame.truePose = m_truePoses.at(index);
    frame.robotPose = m_robotPoses[index];
    frame.reported = m_reportedPoses[index];
    if (m_options.robot.enabled) {
        frame.odometry = m_odometry[index];
        Random noise(m_options.seed, LASER, index);
        frame.laser = m_laser.measure(mrpt::math::TPose2D(frame.robotPose), noise);
    }
    frame.exact = m_renderer.render(frame.truePose);
    Random noise(m_options.seed, DEPTH, index);
    frame.depth = measureDepth(frame.exact, m_camera, m_options.depth, noise);
    frame.predictions =
        m_detector.detect(frame.exact, frame.truePose, Random(m_options.seed, DETECTION, index));
    return frame;
}

std::vector<std::shared_ptr<mrpt::obs::CObservation>> Simulator::robotsOwn(
    const SimulatedFrame& frame) const
{
    const RobotOptions& options = m_options.robot;
    if (!options.enabled) return {};
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = frame.timestamp;
    odometry->sensorLabel = "ODOMETRY";
    odometry->odometry = mrpt::poses::CPose2D(frame.odometry);

    auto laser = mrpt::obs::CObservation2DRangeScan::Create();
    laser->timestamp = frame.timestamp;
    laser->sensorLabel = "LASER";
    laser->sensorPose = mrpt::poses::CPose3D(0, 0, options.laserHeight, 0, 0, 0);
    laser->aperture = mrpt::DEG2RAD(options.laserAperture);
    laser->maxRange = options.laserMaxRange;
    laser->stdError = options.laserSigma;
    laser->rightToLeft = true;
    laser->resizeScan(frame.laser.size());
    for (size_t i = 0; i < frame.laser.size(); ++i) {
        const bool valid = frame.laser[i] > 0;
        laser->setScanRange(i, valid ? frame.laser[i] : options.laserMaxRange);
        laser->setScanRangeValidity(i, valid);
    }
    return {odometry, laser};
}

RgbdRecord Simulator::record(const SimulatedFrame& frame) const
{
    RgbdRecord record;
    record.others = robotsOwn(frame);
    auto scan = mrpt::obs::CObservation3DRangeScan::Create();
    scan->timestamp = frame.timestamp;
    scan->sensorLabel = SENSOR;
    scan->maxRange = m_options.depth.maxRange;
    scan->range_is_depth = true;
    scan->rangeUnits = 0.001F;
    scan->hasRangeImage = true;
    scan->rangeImage_setSize(m_camera.height, m_camera.width);
    std::copy(frame.depth.begin(), frame.depth.end(), scan->rangeImage.data());
    scan->hasIntensityImage = true;
    scan->intensityImage.resize(static_cast<size_t>(m_camera.width),
                                static_cast<size_t>(m_camera.height), mrpt::img::CH_RGB);
    const size_t rowBytes = 3 * static_cast<size_t>(m_camera.width);
    for (size_t row = 0; row < static_cast<size_t>(m_camera.height); ++row)
        std::copy_n(&frame.exact.bgr[row * rowBytes], rowBytes,
                    scan->intensityImage.ptrLine<uint8_t>(static_cast<unsigned>(row)));
    scan->cameraParams = scan->cameraParamsIntensity = mrptCamera(m_camera);
    scan->relativePoseIntensityWRTDepth = mrpt::poses::CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
    if (m_options.robot.enabled)
        scan->sensorPose =
            mrpt::poses::CPose3D(frame.truePose) - mrpt::poses::CPose3D(frame.robotPose);
    record.scan = scan;

    record.robotPose = std::make_shared<mrpt::math::TPose3D>(frame.reported.pose);
    record.poseCovariance = frame.reported.covariance;

    record.instances = CObservationInstances::Create();
    record.instances->timestamp = frame.timestamp;
    record.instances->sensorLabel = std::string(SENSOR) + "_instances";
    record.instances->imageWidth = m_camera.width;
    record.instances->imageHeight = m_camera.height;
    record.instances->instances = frame.predictions;
    return record;
}
}  // namespace voxeland::simulation
