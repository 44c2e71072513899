// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogEntries.h"

#include "voxeland/rawlogs/RawlogFiles.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <filesystem>
#include <utility>
#include <vector>

using namespace mrpt::obs;
namespace fs = std::filesystem;

namespace voxeland::apps
{
RawlogEntries::RawlogEntries(const std::string& file) : m_rawlog(file)
{
    const RawlogFiles files(file);
    files.useImages();
    if (fs::exists(files.sidecar))
        m_sidecar = std::make_unique<GzInputFile>(files.sidecar.string());
}

std::optional<RawlogEntries::Entry> RawlogEntries::next()
{
    if (m_pending) return Entry{nullptr, nullptr, std::exchange(m_pending, nullptr)};
    CActionCollection::Ptr actions;
    while (const auto object = m_rawlog.readObject()) {
        if (const auto observation = std::dynamic_pointer_cast<CObservation>(object)) {
            m_pending = predictionsFor(*observation);
            return Entry{nullptr, nullptr, observation};
        }
        if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object)) {
            std::vector<CObservation::Ptr> predictions;
            for (const auto& observation : *frame)
                if (const auto found = predictionsFor(*observation)) predictions.push_back(found);
            for (const auto& found : predictions) frame->insert(found);
            if (!actions) actions = CActionCollection::Create();
            return Entry{actions, frame, nullptr};
        }
        actions = std::dynamic_pointer_cast<CActionCollection>(object);
    }
    return std::nullopt;
}

CObservationInstances::Ptr RawlogEntries::predictionsFor(const CObservation& observation)
{
    if (dynamic_cast<const CObservation3DRangeScan*>(&observation) == nullptr) return nullptr;
    while (m_sidecar) {
        if (m_nextOfSidecar && m_nextOfSidecar->timestamp > observation.timestamp) break;
        const auto predictions = std::exchange(m_nextOfSidecar, nullptr);
        if (predictions && predictions->timestamp == observation.timestamp) return predictions;
        const auto object = m_sidecar->readObject();
        if (!object) m_sidecar.reset();
        m_nextOfSidecar = std::dynamic_pointer_cast<CObservationInstances>(object);
    }
    return nullptr;
}
}  // namespace voxeland::apps
