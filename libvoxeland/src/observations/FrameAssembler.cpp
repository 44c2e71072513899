// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/FrameAssembler.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

using mrpt::obs::CObservation3DRangeScan;

namespace voxeland
{
void FrameAssembler::addScan(std::shared_ptr<const CObservation3DRangeScan> scan)
{
    m_scans.push_back(std::move(scan));
}

void FrameAssembler::addInstances(std::shared_ptr<const CObservationInstances> instances)
{
    if (m_skipped.erase(instances->timestamp) > 0) return;
    m_instances[instances->timestamp] = std::move(instances);
    forgetOldPredictions();
}

void FrameAssembler::skipScan(const mrpt::Clock::time_point& time)
{
    if (m_instances.erase(time) > 0) return;
    m_skipped.insert(time);
    while (m_skipped.size() > m_patience + 1) m_skipped.erase(m_skipped.begin());
}

std::optional<RgbdFrame> FrameAssembler::next()
{
    while (!m_scans.empty()) {
        const auto& scan = m_scans.front();
        const auto pose = m_poses.at(scan->timestamp);
        const auto instances = m_instances.find(scan->timestamp);
        const bool complete = pose && instances != m_instances.end();
        if (!complete && !m_finished && m_scans.size() <= m_patience) return std::nullopt;

        RgbdFrame frame;
        frame.scan = scan;
        frame.poseCovariance = m_poses.covarianceAt(scan->timestamp);
        if (instances != m_instances.end()) {
            frame.instances = instances->second;
            m_instances.erase(instances);
        }
        // Sensors that share a rawlog may be out of order by a little.
        m_poses.forgetBefore(scan->timestamp - std::chrono::seconds(10));
        m_scans.pop_front();
        forgetOldPredictions();
        if (pose) frame.robotPose = mrpt::poses::CPose3D(*pose);
        if (pose && isValidPose(frame.robotPose)) return frame;
        ++m_counts.framesWithoutPose;
    }
    if (m_finished) {
        m_counts.predictionsWithoutFrame += static_cast<uint32_t>(m_instances.size());
        m_instances.clear();
    }
    return std::nullopt;
}

void FrameAssembler::forgetOldPredictions()
{
    // Predictions may run ahead of their scans, but not by more than scans wait for them.
    while (m_instances.size() > m_scans.size() + m_patience + 1) {
        m_instances.erase(m_instances.begin());
        ++m_counts.predictionsWithoutFrame;
    }
}

void FrameAssembler::writeTo(mrpt::serialization::CArchive& out) const
{
    out << m_patience << m_poses.maxGap() << m_counts.framesWithoutPose
        << m_counts.predictionsWithoutFrame;
    out << static_cast<uint32_t>(m_scans.size());
    for (const auto& scan : m_scans) {
        const auto pose = m_poses.at(scan->timestamp);
        out << *scan << pose.has_value() << pose.value_or(mrpt::math::TPose3D());
    }
    out << static_cast<uint32_t>(m_instances.size());
    for (const auto& [time, instances] : m_instances) out << *instances;
}

void FrameAssembler::readFrom(mrpt::serialization::CArchive& in)
{
    const auto patience = in.ReadAs<uint32_t>();
    *this = FrameAssembler(patience, PoseTrack(in.ReadAs<double>()));
    in >> m_counts.framesWithoutPose >> m_counts.predictionsWithoutFrame;
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n) {
        const auto scan = in.ReadObject<CObservation3DRangeScan>();
        const bool hasPose = in.ReadAs<bool>();
        mrpt::math::TPose3D pose;
        in >> pose;
        if (hasPose) addPose(scan->timestamp, pose);
        addScan(scan);
    }
    for (auto n = in.ReadAs<uint32_t>(); n > 0; --n)
        addInstances(in.ReadObject<CObservationInstances>());
}
}  // namespace voxeland
