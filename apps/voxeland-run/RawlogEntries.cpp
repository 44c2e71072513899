// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogEntries.h"

#include "rawlogs/ImagePaths.h"
#include "rawlogs/RawlogFiles.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

using namespace mrpt::obs;

namespace voxeland::apps
{
RawlogEntries::RawlogEntries(const std::string& file, bool trustsPaths)
    : m_file(file),
      m_trustsPaths(trustsPaths),
      m_rawlog(RawlogFiles::toRead(file).rawlog.string()),
      m_sidecar(
          RawlogFiles(file), [](const auto&) { return true; }, [](uint32_t) {})
{
    RawlogFiles(file).useImages();
}

std::optional<RawlogEntries::Entry> RawlogEntries::next()
{
    if (!m_predictions.empty()) {
        Entry entry{nullptr, nullptr, m_predictions.front()};
        m_predictions.pop_front();
        return entry;
    }
    CActionCollection::Ptr actions;
    while (const auto object = m_rawlog.readObject()) {
        ++m_objectsRead;
        if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
            meet(*observation);
            return Entry{nullptr, nullptr, observation};
        }
        if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
            for (const auto& observation : *frame) meet(*observation);
            for (const auto& predictions : m_predictions) frame->insert(predictions);
            m_predictions.clear();
            if (!actions) actions = CActionCollection::Create();
            return Entry{actions, frame, nullptr};
        }
        actions = std::dynamic_pointer_cast<CActionCollection>(object);
    }
    return std::nullopt;
}

void RawlogEntries::meet(const CObservation& observation)
{
    const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation);
    if (scan == nullptr) return;
    checkImagePaths(*scan, m_file, m_trustsPaths);
    while (const auto predictions = m_sidecar.of(observation.timestamp, m_scans))
        m_predictions.push_back(predictions);
    ++m_scans;
}
}  // namespace voxeland::apps
