// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/PoseUncertainty.h"

#include <mrpt/core/Clock.h>
#include <mrpt/math/TPose3D.h>

#include <map>
#include <optional>
#include <string>

namespace voxeland
{
/** Robot poses over time, in the frame of reference of the map. */
class PoseTrack
{
 public:
    /** \param maxGap longest time between two poses to interpolate over [s] */
    explicit PoseTrack(double maxGap) : m_maxGap(maxGap) {}

    /** Reads a trajectory in the TUM format: lines `timestamp tx ty tz qx qy qz qw`, seconds and
     * metres,
     *  '#' starting comments.
     *  \throws InputError, naming file and line, if it is missing, malformed or holds no pose */
    static PoseTrack fromTumFile(const std::string& file, double maxGap);

    /** Longest time between two poses to interpolate over [s] */
    [[nodiscard]] double maxGap() const { return m_maxGap; }
    void setMaxGap(double maxGap) { m_maxGap = maxGap; }
    void add(const mrpt::Clock::time_point& time, const mrpt::math::TPose3D& pose,
             PoseCovariance covariance = nullptr);
    /** Pose at a time: the one recorded within a millisecond of it, or interpolated (position
     * linearly, rotation along the shortest arc) between two that are at most maxGap apart. */
    [[nodiscard]] std::optional<mrpt::math::TPose3D> at(const mrpt::Clock::time_point& time) const;
    /** Covariance of at(): that of the recorded pose, or the mean of both neighbours', weighted as
     *  the poses are. Whether or not the neighbours' errors depend on one another, the error of the
     *  interpolated position has no greater covariance than that. Null where neither has one. */
    [[nodiscard]] PoseCovariance covarianceAt(const mrpt::Clock::time_point& time) const;
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

    [[nodiscard]] std::optional<Neighbours> neighboursOf(const mrpt::Clock::time_point& time) const;

    double m_maxGap;
    std::map<mrpt::Clock::time_point, Recorded> m_poses;
};
}  // namespace voxeland
