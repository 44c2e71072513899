// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogEntries.h"

#include "voxeland/rawlogs/RawlogFiles.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>

using namespace mrpt::obs;

namespace voxeland::apps
{
RawlogEntries::RawlogEntries(const std::string& file)
    : m_rawlog(file), m_sidecar(RawlogFiles(file)), m_lastScan(mrpt::Clock::time_point::min())
{
    RawlogFiles(file).useImages();
}

std::optional<RawlogEntries::Entry> RawlogEntries::next()
{
    if (const auto predictions = m_sidecar.next(m_lastScan))
        return Entry{nullptr, nullptr, predictions};
    CActionCollection::Ptr actions;
    while (const auto object = m_rawlog.readObject()) {
        ++m_objectsRead;
        if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
            meet(*observation);
            return Entry{nullptr, nullptr, observation};
        }
        if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
            for (const auto& observation : *frame) meet(*observation);
            while (const auto predictions = m_sidecar.next(m_lastScan)) frame->insert(predictions);
            if (!actions) actions = CActionCollection::Create();
            return Entry{actions, frame, nullptr};
        }
        actions = std::dynamic_pointer_cast<CActionCollection>(object);
    }
    return std::nullopt;
}

void RawlogEntries::meet(const CObservation& observation)
{
    if (dynamic_cast<const CObservation3DRangeScan*>(&observation) != nullptr)
        m_lastScan = std::max(m_lastScan, observation.timestamp);
}
}  // namespace voxeland::apps
