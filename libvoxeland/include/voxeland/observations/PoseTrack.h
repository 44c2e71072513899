// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/PoseUncertainty.h"
#include "voxeland/observations/TimeRange.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose3D.h>

#include <map>
#include <optional>

namespace voxeland
{
/** Robot poses over time, in the frame of reference of the map. */
class PoseTrack
{
 public:
    /** \param maxGap longest time between two poses to interpolate over [s] */
    explicit PoseTrack(double maxGap) : m_maxGap(maxGap) {}

    /** Longest time between two poses to interpolate over [s] */
    [[nodiscard]] double maxGap() const { return m_maxGap; }
    void setMaxGap(double maxGap) { m_maxGap = maxGap; }
    void add(const mrpt::Clock::time_point& time, const mrpt::math::TPose3D& pose,
             PoseCovariance covariance = nullptr);
    [[nodiscard]] bool empty() const { return m_poses.empty(); }
    /** Number of poses recorded at exactly this time. */
    [[nodiscard]] size_t recordedAt(const mrpt::Clock::time_point& time) const
    {
        return m_poses.count(time);
    }
    /** Times of the first and the last pose. */
    [[nodiscard]] TimeRange times() const;
    /** Pose at a time: the one recorded within a millisecond of it, or interpolated (position
     * linearly, rotation along the shortest arc) between two that are at most maxGap apart.
     *  \param nth which one, from 0, of several recorded at the same time; the last if there are
     * fewer. \return nothing also for an invalid time */
    [[nodiscard]] std::optional<mrpt::math::TPose3D> at(const mrpt::Clock::time_point& time,
                                                        size_t nth = 0) const;
    /** Covariance of at(): that of the recorded pose, or the mean of both neighbours', weighted as
     *  the poses are. Whether or not the neighbours' errors depend on one another, the error of the
     *  interpolated position has no greater covariance than that. Null where neither has one. */
    [[nodiscard]] PoseCovariance covarianceAt(const mrpt::Clock::time_point& time,
                                              size_t nth = 0) const;
    /** Forgets poses that at() does not need for times from `time` on. */
    void forgetBefore(const mrpt::Clock::time_point& time);

 private:
    struct Recorded
    {
        mrpt::math::TPose3D pose;
        PoseCovariance covariance;
    };
    /** What a time lies between. */
    struct Neighbours
    {
        const Recorded *before, *after;  //!< the same where a pose was recorded at that time
        double share;                    //!< of `after`, in [0,1]
    };

    [[nodiscard]] std::optional<Neighbours> neighboursOf(const mrpt::Clock::time_point& time,
                                                         size_t nth) const;
    /** The nth of those recorded at the time of one. */
    [[nodiscard]] const Recorded* nthOf(const mrpt::Clock::time_point& time, size_t nth) const;

    double m_maxGap;
    std::multimap<mrpt::Clock::time_point, Recorded> m_poses;
};
}  // namespace voxeland
