// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/rawlogs/PredictionSidecar.h"

#include "RawlogFiles.h"
#include "files/GzInputFile.h"

#include <algorithm>
#include <utility>

namespace voxeland
{
namespace
{
constexpr size_t READ_AHEAD = 64;     // predictions, at most
constexpr uint32_t OUT_OF_ORDER = 5;  // frames that predictions may come too early by

double seconds(const mrpt::Clock::time_point& time)
{
    return mrpt::Clock::toDouble(time);
}
}  // namespace

PredictionSidecar::PredictionSidecar(const RawlogFiles& files, Filter isWanted, LeftOver leftOver)
    : m_isWanted(std::move(isWanted)), m_leftOver(std::move(leftOver))
{
    if (std::filesystem::exists(files.sidecar))
        m_input = std::make_unique<GzInputFile>(files.sidecar.string());
}

PredictionSidecar::~PredictionSidecar() = default;

bool PredictionSidecar::readOne()
{
    while (m_input) {
        const auto object = m_input->readObject();
        if (!object) m_input.reset();
        const auto predictions = std::dynamic_pointer_cast<CObservationInstances>(object);
        if (!predictions || !m_isWanted(*predictions)) continue;
        m_times.include(seconds(predictions->timestamp));
        const uint32_t recording =
            m_clock.recordingOf(RecordingClock::Stream::predictions, predictions->timestamp);
        m_ahead.push_back({predictions, std::exchange(m_recording, recording) != recording});
        return true;
    }
    return false;
}

CObservationInstances::Ptr PredictionSidecar::of(const mrpt::Clock::time_point& scan,
                                                 uint32_t frame)
{
    const uint32_t recording = m_scanClock.recordingOf(RecordingClock::Stream::scans, scan);
    if (std::exchange(m_scanRecording, recording) != recording) startRecording(frame);
    CObservationInstances::Ptr found;
    for (size_t i = 0; i < m_ahead.size() || (i < READ_AHEAD && readOne()); ++i) {
        if (m_ahead[i].goesBack && beginsRecording(i, scan)) break;
        const auto time = m_ahead[i].predictions->timestamp;
        if (time == scan) {
            found = std::move(m_ahead[i].predictions);
            m_ahead.erase(m_ahead.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
        if (time < scan && !m_ahead[i].passedBy) m_ahead[i].passedBy = frame;
    }
    dropPassed(frame);
    m_scans.include(seconds(scan));
    return found;
}

void PredictionSidecar::startRecording(uint32_t frame)
{
    m_scans = {};
    size_t first = 0;
    while (first < m_ahead.size() || (first < READ_AHEAD && readOne())) {
        if (m_ahead[first].goesBack) break;
        ++first;
    }
    if (first == m_ahead.size()) return;
    m_ahead[first].goesBack = false;
    while (first-- > 0) drop(0, frame);
}

bool PredictionSidecar::beginsRecording(size_t index, const mrpt::Clock::time_point& scan)
{
    if (!m_scans.contains(seconds(m_ahead[index].predictions->timestamp))) return false;
    // Where time goes on at once, one alone was out of order.
    if (index + 1 == m_ahead.size() && !readOne()) return true;
    return m_ahead[index + 1].predictions->timestamp < scan;
}

void PredictionSidecar::dropPassed(uint32_t frame)
{
    for (size_t i = 0; i < m_ahead.size();) {
        if (m_ahead[i].passedBy && *m_ahead[i].passedBy + OUT_OF_ORDER < frame)
            drop(i, frame);
        else
            ++i;
    }
}

void PredictionSidecar::drop(size_t index, uint32_t frame)
{
    const auto dropped = m_ahead.begin() + static_cast<std::ptrdiff_t>(index);
    m_leftOver(dropped->passedBy.value_or(frame));
    m_ahead.erase(dropped);
}

void PredictionSidecar::finish(uint32_t frame, bool toTheEnd)
{
    do {
        while (!m_ahead.empty()) drop(0, frame);
    } while (toTheEnd && readOne());
}
}  // namespace voxeland
