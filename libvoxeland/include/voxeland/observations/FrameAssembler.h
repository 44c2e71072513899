// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/LeftOut.h"
#include "voxeland/observations/PoseAxes.h"
#include "voxeland/observations/PoseTrack.h"
#include "voxeland/observations/RecordingClock.h"
#include "voxeland/observations/RgbdFrame.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace mrpt::serialization
{
class CArchive;
}

namespace voxeland
{
/** A pose of the robot, and how sure it is. */
struct RobotPose
{
    mrpt::math::TPose3D mean;
    PoseCovariance covariance;
};

/** Puts frames together from depth scans, predictions of the same timestamp and poses, which may
 * come in any order. Of what has the same timestamp, the first goes with the first, the second with
 * the second. Where time goes back, another recording begins (see RecordingClock), whose scans get
 * poses and predictions of their own recording; others only where none of their own came and no
 * other scan can be meant. Memory is bounded: a frame waits for its missing parts while at most
 * `patience` newer ones come. */
class FrameAssembler
{
 public:
    /** What could not be used. */
    struct Counts
    {
        uint32_t framesWithoutPose = 0;        //!< skipped: no valid pose was known in time
        uint32_t predictionsWithoutFrame = 0;  //!< no scan of that timestamp came in time
    };

    /** \param patience newer frames to wait for a frame's predictions or pose
     *  \param maxPoseGap longest time between two poses to interpolate over [s]
     *  \param strict odd poses and predictions are errors */
    FrameAssembler(uint32_t patience, double maxPoseGap, bool strict = false)
        : m_patience(patience),
          m_trajectory(maxPoseGap),
          m_oddPoses(strict),
          m_oddPredictions(strict)
    {
    }

    /** Looks poses up in a trajectory, for all recordings; it comes before poses added. */
    void setTrajectory(PoseTrack trajectory) { m_trajectory = std::move(trajectory); }
    /** Says what the poses of the trajectory and of addPose() are those of. */
    void setPoseAxes(PoseAxes axes) { m_axes = axes; }

    /** Changes what the constructor was given; what waits stays. */
    void setLimits(uint32_t patience, double maxPoseGap);

    /** A pose that is not finite or has no time is left out; a covariance that is none is.
     *  \throws InputError instead if strict */
    void addPose(const mrpt::Clock::time_point& time, const mrpt::math::TPose3D& pose,
                 PoseCovariance covariance = nullptr);
    /** A prediction whose numbers are none, such as a score beyond 0 and 1, is left out, here and
     * in addInstances(). \param instances its predictions, where they come with it \param pose of
     * the robot (whatever the axes of other poses), where that comes with it \throws InputError,
     * for an odd prediction, if strict */
    void addScan(std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> scan,
                 std::shared_ptr<const CObservationInstances> instances = nullptr,
                 std::optional<RobotPose> pose = std::nullopt);
    void addInstances(std::shared_ptr<const CObservationInstances> instances);
    /** Says that the scan of this time is left out on purpose: its predictions, come already or to
     *  come soon, are not counted as being without a frame. */
    void skipScan(const mrpt::Clock::time_point& time);
    /** Nothing more will come: next() gives what is left, complete or not. */
    void finish() { m_finished = true; }

    /** The next frame that is complete or has waited long enough, in the order the scans came. */
    std::optional<RgbdFrame> next();

    /** Whether nothing waits. */
    [[nodiscard]] bool empty() const { return m_scans.empty() && m_instances.empty(); }
    [[nodiscard]] const Counts& counts() const { return m_counts; }
    /** Poses and covariances that are none. */
    [[nodiscard]] const LeftOut& oddPoses() const { return m_oddPoses; }
    /** Predictions whose numbers are none, or whose images are of another size than the camera's.
     */
    [[nodiscard]] const LeftOut& oddPredictions() const { return m_oddPredictions; }
    /** Times of all scans that had one, and of all poses there were. */
    [[nodiscard]] const TimeRange& scanTimes() const { return m_scanTimes; }
    [[nodiscard]] TimeRange poseTimes() const;

    /** What waits, with its poses, the limits and the counts; not what skipScan() was told, nor
     *  covariances, as poses that insertObservation() gives to maps have none. */
    void writeTo(mrpt::serialization::CArchive& out) const;
    void readFrom(mrpt::serialization::CArchive& in);

 private:
    /** When something was measured. */
    struct Moment
    {
        uint32_t recording = 0;
        mrpt::Clock::time_point time;

        bool operator<(const Moment& other) const
        {
            return std::pair(recording, time) < std::pair(other.recording, other.time);
        }
        bool operator==(const Moment& other) const
        {
            return recording == other.recording && time == other.time;
        }
    };
    struct Scan
    {
        std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> scan;
        std::shared_ptr<const CObservationInstances> instances;
        std::optional<RobotPose> pose;  //!< that came with it
        Moment moment;
        size_t nth;  //!< which scan of that moment, from 0
    };
    struct Instances
    {
        std::shared_ptr<const CObservationInstances> instances;
        Moment moment;
    };

    /** Leaves out predictions whose numbers are none. */
    std::shared_ptr<const CObservationInstances> withoutOdd(
        std::shared_ptr<const CObservationInstances> observation);
    /** Leaves out all of them if they are not of the scan's images. */
    std::shared_ptr<const CObservationInstances> ifTheyFit(
        std::shared_ptr<const CObservationInstances> observation,
        const mrpt::obs::CObservation3DRangeScan& scan);
    /** Counts a scan that came, used or not. \return when it was taken, and which it is of those */
    std::pair<Moment, size_t> momentOfScan(const mrpt::Clock::time_point& time);
    /** The pose of a scan, if no other can come that fits better. */
    [[nodiscard]] std::optional<RobotPose> certainPose(const Scan& scan) const;
    /** The pose of a scan whose own can no longer come. */
    [[nodiscard]] std::optional<RobotPose> lastPose(const Scan& scan) const;
    [[nodiscard]] std::optional<RobotPose> lookUp(const PoseTrack& poses, const Scan& scan) const;
    /** Takes predictions that came without a scan of their recording. */
    std::shared_ptr<const CObservationInstances> lastInstances(const mrpt::Clock::time_point& time);
    void forgetOldPoses(const Moment& moment);
    void forgetOldPredictions();

    uint32_t m_patience;
    PoseTrack m_trajectory;                   //!< holds the greatest gap, too
    std::map<uint32_t, PoseTrack> m_poses;    //!< of recordings
    std::map<uint32_t, TimeRange> m_scansOf;  //!< recordings
    PoseAxes m_axes = PoseAxes::body;
    RecordingClock m_clock;
    std::optional<Moment> m_lastScan;
    size_t m_scansOfMoment = 0;  //!< so far, of the last scan's
    bool m_finished = false;
    std::set<Moment> m_skipped;  //!< skipScan() without predictions yet
    std::deque<Scan> m_scans;
    std::deque<Instances> m_instances;  //!< without a scan
    Counts m_counts;
    LeftOut m_oddPoses, m_oddPredictions;
    TimeRange m_scanTimes, m_poseTimes;
};
}  // namespace voxeland
