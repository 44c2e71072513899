// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseTrack.h"

#include "voxeland/errors.h"

#include <Eigen/Dense>
#include <mrpt/math/CQuaternion.h>
#include <mrpt/math/slerp.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/datetime.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

using mrpt::math::TPose3D;

namespace voxeland
{
namespace
{
constexpr double SAME_TIME = 1e-3;  // [s]

/** Pose of one line; false if it is malformed or its quaternion is not of unit length. */
bool parseTumLine(const std::string& line, double& time, TPose3D& pose)
{
    std::istringstream in(line);
    double x, y, z, qx, qy, qz, qw;
    if (!(in >> time >> x >> y >> z >> qx >> qy >> qz >> qw)) return false;
    const double norm = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
    if (!(std::abs(norm - 1) < 1e-2) || !std::isfinite(x + y + z)) return false;
    const mrpt::math::CQuaternionDouble q(qw / norm, qx / norm, qy / norm, qz / norm);
    pose = mrpt::poses::CPose3D(q, x, y, z).asTPose();
    return true;
}
}  // namespace

PoseTrack PoseTrack::fromTumFile(const std::string& file, double maxGap)
{
    std::ifstream in(file);
    if (!in)
        throw InputError("cannot read the trajectory '" + file + "': give a file in TUM format");
    PoseTrack track(maxGap);
    size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
        double time = 0;
        TPose3D pose;
        if (!parseTumLine(line, time, pose))
            throw InputError("line " + std::to_string(number) + " of the trajectory '" + file +
                             "' is not 'timestamp tx ty tz qx qy qz qw' with a unit quaternion");
        track.add(mrpt::Clock::fromDouble(time), pose);
    }
    if (track.m_poses.empty()) throw InputError("the trajectory '" + file + "' holds no pose");
    return track;
}

void PoseTrack::add(const mrpt::Clock::time_point& time, const TPose3D& pose,
                    PoseCovariance covariance)
{
    m_poses[time] = {pose, std::move(covariance)};
}

std::optional<PoseTrack::Neighbours> PoseTrack::neighboursOf(
    const mrpt::Clock::time_point& time) const
{
    using mrpt::system::timeDifference;
    const auto after = m_poses.lower_bound(time);
    const bool hasAfter = after != m_poses.end(), hasBefore = after != m_poses.begin();
    const auto before = hasBefore ? std::prev(after) : after;
    const double toAfter = hasAfter ? timeDifference(time, after->first) : INFINITY;
    const double toBefore = hasBefore ? timeDifference(before->first, time) : INFINITY;
    if (toAfter <= SAME_TIME && toAfter <= toBefore)
        return Neighbours{&after->second, &after->second, 0};
    if (toBefore <= SAME_TIME) return Neighbours{&before->second, &before->second, 0};
    const double gap = toBefore + toAfter;
    if (!(gap <= m_maxGap)) return std::nullopt;
    return Neighbours{&before->second, &after->second, toBefore / gap};
}

std::optional<TPose3D> PoseTrack::at(const mrpt::Clock::time_point& time) const
{
    const auto n = neighboursOf(time);
    if (!n) return std::nullopt;
    if (n->before == n->after) return n->before->pose;
    TPose3D pose;
    mrpt::math::slerp(n->before->pose, n->after->pose, n->share, pose);
    return pose;
}

PoseCovariance PoseTrack::covarianceAt(const mrpt::Clock::time_point& time) const
{
    const auto n = neighboursOf(time);
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
