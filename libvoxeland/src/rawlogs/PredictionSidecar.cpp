// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/PredictionSidecar.h"

#include "voxeland/io/GzInputFile.h"
#include "voxeland/rawlogs/RawlogFiles.h"

#include <utility>

namespace voxeland
{
PredictionSidecar::PredictionSidecar(const RawlogFiles& files)
{
    if (std::filesystem::exists(files.sidecar))
        m_input = std::make_unique<GzInputFile>(files.sidecar.string());
}

PredictionSidecar::~PredictionSidecar() = default;

CObservationInstances::Ptr PredictionSidecar::next(const mrpt::Clock::time_point& until)
{
    while (m_input && !m_later) {
        const auto object = m_input->readObject();
        if (!object) m_input.reset();
        m_later = std::dynamic_pointer_cast<CObservationInstances>(object);
    }
    if (!m_later || m_later->timestamp > until) return nullptr;
    return std::exchange(m_later, nullptr);
}
}  // namespace voxeland
