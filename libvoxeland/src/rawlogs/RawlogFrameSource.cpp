// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/RawlogFrameSource.h"

#include "voxeland/errors.h"
#include "voxeland/io/GzInputFile.h"
#include "voxeland/pipeline/PoseSource.h"
#include "voxeland/rawlogs/RawlogFiles.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

using namespace mrpt::obs;

namespace voxeland
{
namespace
{
PoseTrack initialPoses(const InputOptions& options)
{
    const std::string& source = options.pose_source;
    const std::string problem = problemOfPoseSource(source);
    if (!problem.empty()) throw ConfigurationError(problem);
    if (!isTumPoseSource(source)) return PoseTrack(options.max_pose_gap);
    return PoseTrack::fromTumFile(source.substr(std::string(TUM_POSES).size()),
                                  options.max_pose_gap);
}

/** Increment of the robot's pose in an action; none if it holds no movement. */
mrpt::poses::CPose3D movement(const CActionCollection& actions)
{
    if (const auto in3D = actions.getActionByClass<CActionRobotMovement3D>())
        return in3D->poseChange.getMeanVal();
    if (const auto in2D = actions.getBestMovementEstimation())
        return mrpt::poses::CPose3D(in2D->poseChange->getMeanVal());
    return {};
}

/** Covariance of a pose; null if all of it is 0, as MRPT writes where none is known. */
PoseCovariance covarianceOf(const mrpt::poses::CPose3DPDF& pose)
{
    auto covariance = std::make_shared<const mrpt::math::CMatrixDouble66>(pose.getCovariance());
    return *covariance == mrpt::math::CMatrixDouble66::Zero() ? nullptr : covariance;
}
}  // namespace

RawlogFrameSource::RawlogFrameSource(const std::string& file, const InputOptions& options,
                                     const FrameRange& range)
    : m_file(file),
      m_options(options),
      m_range(range),
      m_input(std::make_unique<GzInputFile>(file)),
      m_sidecar(RawlogFiles(file)),
      m_assembler(options.prediction_wait, initialPoses(options))
{
    RawlogFiles(file).useImages();
}

RawlogFrameSource::~RawlogFrameSource() = default;

std::optional<RgbdFrame> RawlogFrameSource::next()
{
    for (;;) {
        if (auto frame = m_assembler.next()) return frame;
        if (m_finished) return std::nullopt;
        if (m_beyondRange || !readOn()) {
            m_finished = true;
            readSidecar(mrpt::Clock::time_point::max(), m_framesMet);
            m_assembler.finish();
        }
    }
}

FrameAssembler::Counts RawlogFrameSource::skipped() const
{
    FrameAssembler::Counts counts = m_assembler.counts();
    counts.predictionsWithoutFrame += m_sidecarWithoutFrame;
    return counts;
}

double RawlogFrameSource::progress() const
{
    return m_input->progress();
}

bool RawlogFrameSource::readOn()
{
    const auto object = m_input->readObject();
    if (!object) return false;
    take(object);
    return true;
}

void RawlogFrameSource::take(const mrpt::serialization::CSerializable::Ptr& object)
{
    if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
        takeObservation(observation);
    } else if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(object)) {
        m_actionsPose = m_actionsPose + movement(*actions);
    } else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
        for (const auto& o : *frame) {
            if (m_options.pose_source == "actions")
                m_assembler.addPose(o->timestamp, m_actionsPose.asTPose());
            takeObservation(o);
        }
    } else if (const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(object)) {
        // The keyframes' poses hold, not those that a sensor told when the simplemap was made.
        std::string& source = m_options.pose_source;
        if (!isTumPoseSource(source)) source = SIMPLEMAP_POSES;
        for (const auto& keyframe : *map) {
            for (const auto& o : *keyframe.sf) {
                if (source == SIMPLEMAP_POSES)
                    m_assembler.addPose(o->timestamp, keyframe.pose->getMeanVal().asTPose(),
                                        covarianceOf(*keyframe.pose));
                takeObservation(o);
            }
        }
    }
}

void RawlogFrameSource::takeObservation(const CObservation::Ptr& observation)
{
    const std::string& source = m_options.pose_source;
    if (const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(observation)) {
        if (source != "robot_pose") return;
        const mrpt::poses::CPose3D robotInSensor = mrpt::poses::CPose3D() - pose->sensorPose;
        mrpt::poses::CPose3DPDFGaussian robot = pose->pose;
        if (robotInSensor != mrpt::poses::CPose3D()) robot += robotInSensor;
        m_assembler.addPose(pose->timestamp, (pose->pose.mean + robotInSensor).asTPose(),
                            covarianceOf(robot));
    } else if (const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation)) {
        if (source == "odometry")
            m_assembler.addPose(odometry->timestamp,
                                mrpt::poses::CPose3D(odometry->odometry).asTPose());
    } else if (const auto predictions =
                   std::dynamic_pointer_cast<CObservationInstances>(observation)) {
        const std::string& label = m_options.instances_sensor_label;
        if (label.empty() || label == predictions->sensorLabel)
            m_assembler.addInstances(predictions);
    } else if (std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) {
        takeScan(observation);
    }
}

void RawlogFrameSource::takeScan(const CObservation::Ptr& observation)
{
    std::string& label = m_options.depth_sensor_label;
    if (label.empty()) label = observation->sensorLabel;
    if (label != observation->sensorLabel) return;
    const uint32_t number = m_framesMet++;
    // Poses and predictions of the last frames may come as late as for any other frame.
    m_beyondRange = number > m_range.to && number - m_range.to >= m_options.prediction_wait;
    readSidecar(observation->timestamp, number);
    if (!isWanted(number)) {
        m_assembler.skipScan(observation->timestamp);
        return;
    }
    m_assembler.addScan(std::dynamic_pointer_cast<CObservation3DRangeScan>(observation));
}

bool RawlogFrameSource::isWanted(uint32_t number) const
{
    return number >= m_range.from && number <= m_range.to &&
           (number - m_range.from) % m_range.every == 0;
}

void RawlogFrameSource::readSidecar(const mrpt::Clock::time_point& until, uint32_t frameNumber)
{
    if (frameNumber > m_range.to) return;
    const std::string& label = m_options.instances_sensor_label;
    while (const auto predictions = m_sidecar.next(until)) {
        if (!label.empty() && label != predictions->sensorLabel) continue;
        if (predictions->timestamp < until)
            m_sidecarWithoutFrame += frameNumber >= m_range.from ? 1 : 0;
        else if (isWanted(frameNumber))
            m_assembler.addInstances(predictions);
    }
}
}  // namespace voxeland
