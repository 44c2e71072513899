// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/RawlogFrameSource.h"

#include "ImagePaths.h"
#include "RawlogFiles.h"
#include "files/GzInputFile.h"
#include "observations/Trajectory.h"
#include "pipeline/PoseSource.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cmath>

using namespace mrpt::obs;

namespace voxeland
{
namespace
{
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
                                     const FrameRange& range, bool strict)
    : m_file(file),
      m_options(options),
      m_range(range),
      m_strict(strict),
      m_cameras("scans", options.depth_sensor_label, "depth_sensor_label"),
      m_detectors("predictions", options.instances_sensor_label, "instances_sensor_label"),
      m_poseSensors("poses", options.pose_sensor_label, "pose_sensor_label"),
      m_input(std::make_unique<GzInputFile>(RawlogFiles::toRead(file).rawlog.string())),
      m_sidecar(
          RawlogFiles(file), [this](const auto& p) { return isOfTheDetector(p); },
          [this](uint32_t laterFrame) { countWithoutFrame(laterFrame); }),
      m_assembler(options.prediction_wait, options.max_pose_gap, strict),
      m_lastAskedFor(range.to)
{
    const std::string& source = options.pose_source;
    const std::string problem = problemOfPoseSource(source);
    if (!problem.empty()) throw ConfigurationError(problem);
    m_assembler.setPoseAxes(options.pose_axes);
    if (isTumPoseSource(source)) {
        auto trajectory = Trajectory::fromTumFile(source.substr(std::string(TUM_POSES).size()),
                                                  options.max_pose_gap, strict);
        m_assembler.setTrajectory(std::move(trajectory.poses));
        m_trajectoryNotes = std::move(trajectory.notes);
    }
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
            finishStopping();
            m_sidecar.finish(m_framesMet, m_framesMet <= m_range.to);
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

std::vector<std::string> RawlogFrameSource::notes() const
{
    std::vector<std::string> notes = m_trajectoryNotes;
    for (const LabelChoice* choice : {&m_cameras, &m_detectors, &m_poseSensors})
        choice->tell(notes);
    if (const uint64_t damaged = m_input->damagedPictures(); damaged > 0)
        notes.push_back(counted(damaged, "picture") +
                        " of the rawlog damaged (--strict: an error): parts are grey, of wrong "
                        "colours or missing");
    const auto tell = [&](const LeftOut& odd, const char* one, const char* several) {
        if (odd.count() > 0) notes.push_back(odd.told(one, several));
    };
    tell(m_assembler.oddPoses(), "pose or covariance of the rawlog",
         "poses or covariances of the rawlog");
    tell(m_assembler.oddPredictions(), "prediction of the rawlog", "predictions of the rawlog");
    const uint32_t lost = m_assembler.counts().framesWithoutPose;
    if (lost > 0)
        notes.push_back(counted(lost, "frame") + " left out without a pose: " + whyNoPoses());
    if (m_sidecarWithoutFrame > 0 && m_sidecarMatched == 0)
        notes.push_back(
            "predictions of " + counted(m_sidecarWithoutFrame, "image") +
            " in the file beside the rawlog belong to none of its frames: those are of " +
            m_assembler.scanTimes().text() + ", the predictions of " + m_sidecar.times().text());
    return notes;
}

std::string RawlogFrameSource::whyNoFrames() const
{
    const std::string others = m_cameras.othersThanAsked();
    return others.empty() ? "the rawlog holds no CObservation3DRangeScan: only RGB-D frames can be "
                            "mapped"
                          : others;
}

std::string RawlogFrameSource::whyNoPoses() const
{
    const TimeRange frames = m_assembler.scanTimes(), poses = m_assembler.poseTimes();
    const bool fromFile = isTumPoseSource(m_options.pose_source);
    if (frames.empty())
        return "they have no timestamps, by which poses are found: set those of the scans";
    if (poses.empty() && !m_poseSensors.othersThanAsked().empty())
        return m_poseSensors.othersThanAsked();
    if (poses.empty())
        return "there are no poses of pose_source = " + m_options.pose_source +
               ": choose another one, or give a trajectory with --poses";
    const std::string times = "the frames are of " + frames.text() + ", the poses of " +
                              (fromFile ? "the trajectory " : "") + poses.text() + ": ";
    if (!frames.overlaps(poses))
        return times + (fromFile ? "give the trajectory's times in seconds from the rawlog's zero"
                                 : "give a trajectory of the frames' times with --poses");
    return times + "no two around theirs are within max_pose_gap (" +
           numberText(m_options.max_pose_gap) + " s)";
}

bool RawlogFrameSource::readOn()
{
    if (m_simplemap && m_nextKeyframe < m_simplemap->size()) {
        takeKeyframe(m_nextKeyframe++);
        return true;
    }
    const auto object = m_input->readObject();
    if (!object) return false;
    if (m_strict && m_input->damagedPictures() > 0)
        throw InputError(m_file + " has a damaged picture among the first " +
                         counted(m_framesMet + 1, "frame") + ": make it anew");
    take(object);
    return true;
}

void RawlogFrameSource::take(const mrpt::serialization::CSerializable::Ptr& object)
{
    if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
        takeObservation(observation);
    } else if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(object)) {
        m_framePose.mean = (mrpt::poses::CPose3D(m_framePose.mean) + movement(*actions)).asTPose();
    } else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
        for (const auto& o : *frame) {
            takeObservation(o);
        }
    } else if (const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(object)) {
        // The keyframes' poses hold, not those that a sensor told when the simplemap was made.
        std::string& source = m_options.pose_source;
        if (!isTumPoseSource(source)) source = SIMPLEMAP_POSES;
        m_simplemap = map;
        m_nextKeyframe = 0;
    } else if (std::string_view(object->GetRuntimeClass()->className) == "voxeland::CVoxelandMap") {
        throw InputError(m_file +
                         " is a map, not a rawlog: give the rawlog (to go on with a map: "
                         "--resume)");
    }
}

void RawlogFrameSource::takeKeyframe(size_t index)
{
    mrpt::poses::CPose3DPDF::Ptr pose;
    CSensoryFrame::Ptr observations;
    m_simplemap->get(index, pose, observations);
    m_framePose = {pose->getMeanVal().asTPose(), covarianceOf(*pose)};
    for (const auto& o : *observations) {
        takeObservation(o);
    }
}

void RawlogFrameSource::takeObservation(const CObservation::Ptr& observation)
{
    const std::string& source = m_options.pose_source;
    if (const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(observation)) {
        if (source != "robot_pose" || !m_poseSensors.takes(pose->sensorLabel)) return;
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
        if (isOfTheDetector(*predictions)) m_assembler.addInstances(predictions);
    } else if (std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) {
        takeScan(observation);
    }
}

void RawlogFrameSource::takeScan(const CObservation::Ptr& observation)
{
    if (!m_cameras.takes(observation->sensorLabel)) return;
    const uint32_t number = m_framesMet++;
    if (!m_stoppedBefore && m_stopWanted()) stopBehind(number);
    // Poses and predictions of the last frames may come as late as for any other frame.
    m_beyondRange = (number > m_range.to && number - m_range.to >= m_options.prediction_wait) ||
                    m_range.to < m_range.from;
    estimateFrames();
    CObservationInstances::Ptr predictions;
    if (number <= m_range.to) predictions = m_sidecar.of(observation->timestamp, number);
    if (predictions) ++m_sidecarMatched;
    if (!isWanted(number)) {
        m_assembler.skipScan(observation->timestamp);
        return;
    }
    const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation);
    checkImagePaths(*scan, m_file, m_options.trust_paths);
    std::optional<RobotPose> pose;
    if (m_options.pose_source == "actions" || m_options.pose_source == SIMPLEMAP_POSES)
        pose = m_framePose;
    m_assembler.addScan(scan, predictions, pose);
}

bool RawlogFrameSource::isWanted(uint32_t number) const
{
    return number >= m_range.from && number <= m_range.to &&
           (number - m_range.from) % m_range.every == 0;
}

uint32_t RawlogFrameSource::nextWanted(uint32_t number) const
{
    const auto& [from, to, every] = m_range;
    return number < from ? from : from + ((number - from) / every + 1) * every;
}

void RawlogFrameSource::stopBehind(uint32_t number)
{
    const uint32_t next = nextWanted(number);
    if (next > m_range.to) return;
    m_stoppedBefore = next;
    m_range.to = next - 1;
}

void RawlogFrameSource::finishStopping()
{
    if (!m_stoppedBefore || *m_stoppedBefore < m_framesMet || m_beyondRange) return;
    m_stoppedBefore.reset();
    m_range.to = m_lastAskedFor;
}

void RawlogFrameSource::estimateFrames()
{
    const double share =
        m_simplemap ? static_cast<double>(m_nextKeyframe) / static_cast<double>(m_simplemap->size())
                    : m_input->progress();
    const double inFile = m_framesMet / std::clamp(share, 1e-6, 1.0);
    const double end = std::min(inFile, m_range.to + 1.0);
    const double used = std::ceil((end - m_range.from) / m_range.every);
    const double withoutPose = m_assembler.counts().framesWithoutPose;
    m_expectedFrames = static_cast<uint32_t>(std::clamp(used - withoutPose, 1.0, 4e9));
}

void RawlogFrameSource::countWithoutFrame(uint32_t laterFrame)
{
    if (laterFrame >= m_range.from && laterFrame <= m_range.to) ++m_sidecarWithoutFrame;
}

bool RawlogFrameSource::isOfTheDetector(const CObservationInstances& predictions)
{
    // Where several cameras have predictions, those of the camera's own label are its own.
    const std::string& label = predictions.sensorLabel;
    if (m_framesMet > 0 && label == m_cameras.label()) m_detectors.prefer(label);
    return m_detectors.takes(label);
}
}  // namespace voxeland
