// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/rawlogs/RgbdRawlogWriter.h"
#include "voxeland/simulation/CameraPath.h"
#include "voxeland/simulation/LaserScanner.h"
#include "voxeland/simulation/Localization.h"
#include "voxeland/simulation/NoisyDetector.h"
#include "voxeland/simulation/SceneRenderer.h"

#include <mrpt/core/Clock.h>

#include <vector>

namespace voxeland::simulation
{
/** All there is to know about one frame. */
struct SimulatedFrame
{
    mrpt::Clock::time_point timestamp;
    mrpt::math::TPose3D truePose;   //!< of the camera, x forward, z up
    mrpt::math::TPose3D robotPose;  //!< of what carries the camera; without a robot, the same
    ReportedPose reported;          //!< the robot's, with the localization's errors
    mrpt::math::TPose2D odometry;   //!< the robot's, as its wheels tell it
    std::vector<float> laser;       //!< see LaserScanner; empty without a robot
    RenderedView exact;             //!< what is really there
    std::vector<uint16_t> depth;    //!< what the depth camera measures [mm]; 0: nothing
    std::vector<InstancePrediction> predictions;  //!< what the detector says
};

/** A furnished apartment, a camera carried through it, and what its sensors and a detector say.
 *  Frames depend on nothing but the options and their number. */
class Simulator
{
 public:
    /** \throws ConfigurationError if an option makes no sense */
    explicit Simulator(const SimulationOptions& options);
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    [[nodiscard]] const Scene& scene() const { return m_scene; }
    [[nodiscard]] const RenderCamera& camera() const { return m_camera; }
    [[nodiscard]] size_t size() const { return m_truePoses.size(); }

    /** Computes a frame; safe to call from several threads. \param index in [0, size()) */
    [[nodiscard]] SimulatedFrame frame(size_t index) const;
    /** The frame as MRPT observations: scan "RGBD", predictions "RGBD_instances"; of a robot also
     *  "LASER" and "ODOMETRY". */
    [[nodiscard]] RgbdRecord record(const SimulatedFrame& frame) const;

 private:
    /** What the robot's own sensors say. */
    [[nodiscard]] std::vector<std::shared_ptr<mrpt::obs::CObservation>> robotsOwn(
        const SimulatedFrame& frame) const;

    SimulationOptions m_options;
    Scene m_scene;
    RenderCamera m_camera;
    std::vector<mrpt::math::TPose3D> m_truePoses, m_robotPoses;
    std::vector<ReportedPose> m_reportedPoses;
    std::vector<mrpt::math::TPose2D> m_odometry;
    SceneRenderer m_renderer;
    LaserScanner m_laser;
    NoisyDetector m_detector;
};
}  // namespace voxeland::simulation
