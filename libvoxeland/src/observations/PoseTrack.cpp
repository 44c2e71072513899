// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseTrack.h"

#include <Eigen/Dense>
#include <mrpt/math/slerp.h>
#include <mrpt/system/datetime.h>

#include <cmath>
#include <iterator>

using mrpt::math::TPose3D;

namespace voxeland
{
namespace
{
constexpr double SAME_TIME = 1e-3;  // [s]
}  // namespace

void PoseTrack::add(const mrpt::Clock::time_point& time, const TPose3D& pose,
                    PoseCovariance covariance)
{
    m_poses.emplace(time, Recorded{pose, std::move(covariance)});
}

std::optional<PoseTrack::Neighbours> PoseTrack::neighboursOf(const mrpt::Clock::time_point& time,
                                                             size_t nth) const
{
    if (time == INVALID_TIMESTAMP) return std::nullopt;
    const auto after = m_poses.lower_bound(time);
    const bool hasAfter = after != m_poses.end(), hasBefore = after != m_poses.begin();
    const auto before = hasBefore ? std::prev(after) : after;
    const double toAfter = hasAfter ? secondsBetween(time, after->first) : INFINITY;
    const double toBefore = hasBefore ? secondsBetween(before->first, time) : INFINITY;
    if (toAfter <= SAME_TIME && toAfter <= toBefore)
        return Neighbours{nthOf(after->first, nth), nthOf(after->first, nth), 0};
    if (toBefore <= SAME_TIME)
        return Neighbours{nthOf(before->first, nth), nthOf(before->first, nth), 0};
    const double gap = toBefore + toAfter;
    if (!(gap <= m_maxGap)) return std::nullopt;
    return Neighbours{&before->second, &after->second, toBefore / gap};
}

const PoseTrack::Recorded* PoseTrack::nthOf(const mrpt::Clock::time_point& time, size_t nth) const
{
    auto [recorded, end] = m_poses.equal_range(time);
    while (nth-- > 0 && std::next(recorded) != end) ++recorded;
    return &recorded->second;
}

TimeRange PoseTrack::times() const
{
    TimeRange range;
    if (empty()) return range;
    range.include(mrpt::Clock::toDouble(m_poses.begin()->first));
    range.include(mrpt::Clock::toDouble(m_poses.rbegin()->first));
    return range;
}

std::optional<TPose3D> PoseTrack::at(const mrpt::Clock::time_point& time, size_t nth) const
{
    const auto n = neighboursOf(time, nth);
    if (!n) return std::nullopt;
    if (n->before == n->after) return n->before->pose;
    TPose3D pose;
    mrpt::math::slerp(n->before->pose, n->after->pose, n->share, pose);
    return pose;
}

PoseCovariance PoseTrack::covarianceAt(const mrpt::Clock::time_point& time, size_t nth) const
{
    const auto n = neighboursOf(time, nth);
    if (!n || (!n->before->covariance && !n->after->covariance)) return nullptr;
    if (n->before == n->after) return n->before->covariance;
    auto mean = std::make_shared<mrpt::math::CMatrixDouble66>();
    mean->setZero();
    if (n->before->covariance) mean->asEigen() += (1 - n->share) * n->before->covariance->asEigen();
    if (n->after->covariance) mean->asEigen() += n->share * n->after->covariance->asEigen();
    return mean;
}

void PoseTrack::forgetBefore(const mrpt::Clock::time_point& time)
{
    auto first = m_poses.lower_bound(time);
    if (first == m_poses.begin()) return;
    m_poses.erase(m_poses.begin(), std::prev(first));
}
}  // namespace voxeland
