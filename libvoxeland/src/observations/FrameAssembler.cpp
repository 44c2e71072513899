// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/FrameAssembler.h"

#include "MaskCamera.h"
#include "base/Reading.h"
#include "base/timeText.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/numbers.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>

using mrpt::obs::CObservation3DRangeScan;

namespace voxeland
{
namespace
{
constexpr size_t RECORDINGS_KEPT = 16;     // whose poses are remembered
constexpr size_t MOST_PREDICTIONS = 1000;  // of an image

bool isFinite(const mrpt::math::TPose3D& pose)
{
    return std::isfinite(pose.x + pose.y + pose.z + pose.yaw + pose.pitch + pose.roll);
}

bool isCovariance(const mrpt::math::CMatrixDouble66& matrix)
{
    for (int row = 0; row < 6; ++row) {
        if (!(matrix(row, row) >= 0)) return false;
        for (int col = 0; col < 6; ++col)
            if (!std::isfinite(matrix(row, col))) return false;
    }
    return true;
}

/** What is wrong with the numbers of a prediction; empty: nothing is. */
std::string oddityOf(const InstancePrediction& p, const CObservationInstances& image)
{
    if (!(p.score >= 0 && p.score <= 1))
        return "has a score of " + numberText(p.score) + ", which is not within 0 and 1";
    if (p.mask.width() != image.imageWidth || p.mask.height() != image.imageHeight)
        return "has a mask of another size than its image";
    double sum = 0;
    for (const auto& c : p.categories) {
        if (!(c.probability >= 0 && std::isfinite(c.probability)))
            return "has a category of probability " + numberText(c.probability);
        sum += static_cast<double>(c.probability);
    }
    return sum > 0 || p.categories.empty() ? "" : "has categories of no probability";
}

/** The robot's pose, given that of some axes of a sensor on it. */
RobotPose ofRobot(const RobotPose& given, PoseAxes axes, const mrpt::poses::CPose3D& sensorOnRobot)
{
    const mrpt::poses::CPose3D robotInAxes = -(sensorOnRobot + poseOfAxes(axes));
    const mrpt::poses::CPose3D mean(given.mean);
    if (!given.covariance) return {(mean + robotInAxes).asTPose(), nullptr};
    mrpt::poses::CPose3DPDFGaussian pose(mean, *given.covariance);
    pose += robotInAxes;
    return {pose.mean.asTPose(), std::make_shared<const mrpt::math::CMatrixDouble66>(pose.cov)};
}

template <typename OfRecordings>
void keepLatest(OfRecordings& values)
{
    while (values.size() > RECORDINGS_KEPT) values.erase(values.begin());
}
}  // namespace

void FrameAssembler::setLimits(uint32_t patience, double maxPoseGap)
{
    m_patience = patience;
    m_trajectory.setMaxGap(maxPoseGap);
    for (auto& [recording, poses] : m_poses) poses.setMaxGap(maxPoseGap);
}

void FrameAssembler::addPose(const mrpt::Clock::time_point& time, const mrpt::math::TPose3D& pose,
                             PoseCovariance covariance)
{
    if (time == INVALID_TIMESTAMP) return m_oddPoses.add("a pose has no timestamp");
    const auto named = [&] { return "the pose of " + timeText(time); };
    if (!isFinite(pose)) return m_oddPoses.add(named() + " has numbers that are not finite");
    if (!isValidPose(mrpt::poses::CPose3D(pose)))
        return m_oddPoses.add(named() + " lies 1e9 m or more from the origin");
    if (covariance && !isCovariance(*covariance)) {
        m_oddPoses.add("the covariance of " + named() +
                       " has negative variances or numbers that are not finite");
        covariance = nullptr;
    }
    m_poseTimes.include(mrpt::Clock::toDouble(time));
    const uint32_t recording = m_clock.recordingOf(RecordingClock::Stream::poses, time);
    m_poses.try_emplace(recording, m_trajectory.maxGap())
        .first->second.add(time, pose, std::move(covariance));
    keepLatest(m_poses);
}

std::pair<FrameAssembler::Moment, size_t> FrameAssembler::momentOfScan(
    const mrpt::Clock::time_point& time)
{
    const Moment moment{m_clock.recordingOf(RecordingClock::Stream::scans, time), time};
    m_scansOfMoment = m_lastScan && *m_lastScan == moment ? m_scansOfMoment + 1 : 0;
    m_lastScan = moment;
    if (time != INVALID_TIMESTAMP) {
        m_scanTimes.include(mrpt::Clock::toDouble(time));
        m_scansOf[moment.recording].include(mrpt::Clock::toDouble(time));
        keepLatest(m_scansOf);
    }
    return {moment, m_scansOfMoment};
}

std::shared_ptr<const CObservationInstances> FrameAssembler::withoutOdd(
    std::shared_ptr<const CObservationInstances> observation)
{
    std::vector<const InstancePrediction*> usable;  // masks are copied only if some are left out
    size_t number = 0;
    for (const InstancePrediction& p : observation->instances) {
        ++number;
        const std::string oddity = oddityOf(p, *observation);
        if (oddity.empty())
            usable.push_back(&p);
        else
            m_oddPredictions.add("prediction " + std::to_string(number) + " of the image of " +
                                 timeText(observation->timestamp) + " " + oddity);
    }
    if (usable.size() > MOST_PREDICTIONS) {
        m_oddPredictions.add("of " + counted(usable.size(), "prediction") + " of the image of " +
                             timeText(observation->timestamp) + " the " +
                             std::to_string(MOST_PREDICTIONS) +
                             " with the highest scores are used: raise the detector's threshold");
        std::stable_sort(usable.begin(), usable.end(),
                         [](const auto* a, const auto* b) { return a->score > b->score; });
        usable.resize(MOST_PREDICTIONS);
    }
    if (usable.size() == observation->instances.size()) return observation;
    std::vector<InstancePrediction> kept;
    for (const InstancePrediction* p : usable) kept.push_back(*p);
    auto changed = std::make_shared<CObservationInstances>(*observation);
    changed->instances = std::move(kept);
    return changed;
}

std::shared_ptr<const CObservationInstances> FrameAssembler::ifTheyFit(
    std::shared_ptr<const CObservationInstances> observation, const CObservation3DRangeScan& scan)
{
    const std::string misfit = observation ? misfitOf(*observation, scan) : "";
    if (misfit.empty()) return observation;
    for (size_t i = 0; i < observation->instances.size(); ++i) m_oddPredictions.add(misfit);
    return nullptr;
}

void FrameAssembler::addScan(std::shared_ptr<const CObservation3DRangeScan> scan,
                             std::shared_ptr<const CObservationInstances> instances,
                             std::optional<RobotPose> pose)
{
    const auto [moment, nth] = momentOfScan(scan->timestamp);
    if (instances) {
        instances = withoutOdd(std::move(instances));
    } else {
        const auto waiting =
            std::find_if(m_instances.begin(), m_instances.end(),
                         [m = moment](const Instances& i) { return i.moment == m; });
        if (waiting != m_instances.end()) {
            instances = std::move(waiting->instances);
            m_instances.erase(waiting);
        }
    }
    m_scans.push_back({std::move(scan), std::move(instances), std::move(pose), moment, nth});
}

void FrameAssembler::addInstances(std::shared_ptr<const CObservationInstances> instances)
{
    const auto time = instances->timestamp;
    const Moment moment{m_clock.recordingOf(RecordingClock::Stream::predictions, time), time};
    if (m_skipped.erase(moment) > 0) return;
    instances = withoutOdd(std::move(instances));
    const auto scan = std::find_if(m_scans.begin(), m_scans.end(), [&](const Scan& s) {
        return !s.instances && s.moment == moment;
    });
    if (scan != m_scans.end()) {
        scan->instances = std::move(instances);
        return;
    }
    m_instances.push_back({std::move(instances), moment});
    forgetOldPredictions();
}

void FrameAssembler::skipScan(const mrpt::Clock::time_point& time)
{
    const Moment moment = momentOfScan(time).first;
    const auto waiting = std::find_if(m_instances.begin(), m_instances.end(),
                                      [&](const Instances& i) { return i.moment == moment; });
    if (waiting != m_instances.end()) {
        m_instances.erase(waiting);
        return;
    }
    m_skipped.insert(moment);
    while (m_skipped.size() > m_patience + 1) m_skipped.erase(m_skipped.begin());
}

std::optional<RobotPose> FrameAssembler::lookUp(const PoseTrack& poses, const Scan& scan) const
{
    const auto mean = poses.at(scan.moment.time, scan.nth);
    if (!mean) return std::nullopt;
    const RobotPose given{*mean, poses.covarianceAt(scan.moment.time, scan.nth)};
    if (m_axes == PoseAxes::body) return given;
    return ofRobot(given, m_axes, scan.scan->sensorPose);
}

std::optional<RobotPose> FrameAssembler::certainPose(const Scan& scan) const
{
    if (scan.pose) return scan.pose;
    if (!m_trajectory.empty()) return lookUp(m_trajectory, scan);
    const auto own = m_poses.find(scan.moment.recording);
    if (own == m_poses.end()) return std::nullopt;
    const bool mayCome = scan.nth > 0 && own->second.recordedAt(scan.moment.time) <= scan.nth;
    return mayCome ? std::nullopt : lookUp(own->second, scan);
}

std::optional<RobotPose> FrameAssembler::lastPose(const Scan& scan) const
{
    if (auto pose = certainPose(scan)) return pose;
    const auto own = m_poses.find(scan.moment.recording);
    if (own != m_poses.end())
        if (auto pose = lookUp(own->second, scan)) return pose;
    for (auto other = m_poses.rbegin(); other != m_poses.rend(); ++other) {
        const auto scans = m_scansOf.find(other->first);
        const bool areOfItsScans = scans != m_scansOf.end() &&
                                   scans->second.contains(mrpt::Clock::toDouble(scan.moment.time));
        if (areOfItsScans) continue;
        if (auto pose = lookUp(other->second, scan)) return pose;
    }
    return std::nullopt;
}

std::shared_ptr<const CObservationInstances> FrameAssembler::lastInstances(
    const mrpt::Clock::time_point& time)
{
    const auto found = std::find_if(m_instances.begin(), m_instances.end(),
                                    [&](const Instances& i) { return i.moment.time == time; });
    if (found == m_instances.end()) return nullptr;
    auto instances = std::move(found->instances);
    m_instances.erase(found);
    return instances;
}

std::optional<RgbdFrame> FrameAssembler::next()
{
    while (!m_scans.empty()) {
        Scan& scan = m_scans.front();
        auto pose = certainPose(scan);
        const bool complete = pose && scan.instances;
        if (!complete && !m_finished && m_scans.size() <= m_patience) return std::nullopt;

        if (!pose) pose = lastPose(scan);
        RgbdFrame frame;
        frame.scan = std::move(scan.scan);
        frame.instances =
            ifTheyFit(scan.instances ? std::move(scan.instances) : lastInstances(scan.moment.time),
                      *frame.scan);
        forgetOldPoses(scan.moment);
        m_scans.pop_front();
        forgetOldPredictions();
        if (pose) {
            frame.robotPose = mrpt::poses::CPose3D(pose->mean);
            frame.poseCovariance = std::move(pose->covariance);
            if (isValidPose(frame.robotPose)) return frame;
        }
        ++m_counts.framesWithoutPose;
    }
    if (m_finished) {
        m_counts.predictionsWithoutFrame += static_cast<uint32_t>(m_instances.size());
        m_instances.clear();
    }
    return std::nullopt;
}

void FrameAssembler::forgetOldPoses(const Moment& moment)
{
    // Sensors that share a rawlog may be out of order by a little.
    constexpr auto KEPT = std::chrono::seconds(10);
    const auto poses = m_poses.find(moment.recording);
    if (poses != m_poses.end() && moment.time > mrpt::Clock::time_point::min() + KEPT)
        poses->second.forgetBefore(moment.time - KEPT);
}

void FrameAssembler::forgetOldPredictions()
{
    // Predictions may run ahead of their scans, but not by more than scans wait for them.
    while (m_instances.size() > m_scans.size() + m_patience + 1) {
        m_instances.pop_front();
        ++m_counts.predictionsWithoutFrame;
    }
}

TimeRange FrameAssembler::poseTimes() const
{
    return m_trajectory.empty() ? m_poseTimes : m_trajectory.times();
}

void FrameAssembler::writeTo(mrpt::serialization::CArchive& out) const
{
    out << m_patience << m_trajectory.maxGap() << m_counts.framesWithoutPose
        << m_counts.predictionsWithoutFrame;
    out << static_cast<uint32_t>(m_scans.size());
    for (const Scan& scan : m_scans) {
        const auto pose = certainPose(scan);
        out << *scan.scan << pose.has_value();
        out << (pose ? pose->mean : mrpt::math::TPose3D());
    }
    std::vector<const CObservationInstances*> instances;
    for (const Scan& scan : m_scans)
        if (scan.instances) instances.push_back(scan.instances.get());
    for (const Instances& i : m_instances) instances.push_back(i.instances.get());
    out << static_cast<uint32_t>(instances.size());
    for (const auto* i : instances) out << *i;
}

void FrameAssembler::readFrom(mrpt::serialization::CArchive& in)
{
    const auto patience = in.ReadAs<uint32_t>();
    *this = FrameAssembler(patience, in.ReadAs<double>());
    in >> m_counts.framesWithoutPose >> m_counts.predictionsWithoutFrame;
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        const auto scan = readObject<CObservation3DRangeScan>(in);
        const bool hasPose = readTruth(in);
        RobotPose pose;
        in >> pose.mean;
        addScan(scan, nullptr, hasPose ? std::optional(pose) : std::nullopt);
    }
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n)
        addInstances(readObject<CObservationInstances>(in));
}
}  // namespace voxeland
