// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/PoseTrack.h"
#include "voxeland/observations/RgbdFrame.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace mrpt::serialization
{
class CArchive;
}

namespace voxeland
{
/** Puts frames together from depth scans, predictions of the same timestamp and poses, which may
 * come in any order. Memory is bounded: a frame waits for its missing parts while at most
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
     *  \param poses where poses are looked up and added; its gap limits interpolation */
    FrameAssembler(uint32_t patience, PoseTrack poses)
        : m_patience(patience), m_poses(std::move(poses))
    {
    }

    /** Changes what the constructor was given; what waits stays. */
    void setLimits(uint32_t patience, double maxPoseGap)
    {
        m_patience = patience;
        m_poses.setMaxGap(maxPoseGap);
    }

    void addPose(const mrpt::Clock::time_point& time, const mrpt::math::TPose3D& pose,
                 PoseCovariance covariance = nullptr)
    {
        m_poses.add(time, pose, std::move(covariance));
    }
    void addScan(std::shared_ptr<const mrpt::obs::CObservation3DRangeScan> scan);
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

    /** What waits, with its poses, the limits and the counts; not what skipScan() was told, nor
     *  covariances, as poses that insertObservation() gives to maps have none. */
    void writeTo(mrpt::serialization::CArchive& out) const;
    void readFrom(mrpt::serialization::CArchive& in);

 private:
    void forgetOldPredictions();

    uint32_t m_patience;
    PoseTrack m_poses;
    bool m_finished = false;
    std::set<mrpt::Clock::time_point> m_skipped;  //!< skipScan() without predictions yet
    std::deque<std::shared_ptr<const mrpt::obs::CObservation3DRangeScan>> m_scans;
    std::map<mrpt::Clock::time_point, std::shared_ptr<const CObservationInstances>> m_instances;
    Counts m_counts;
};
}  // namespace voxeland
