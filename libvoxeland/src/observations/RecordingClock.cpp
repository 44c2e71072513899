// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/RecordingClock.h"

#include "voxeland/observations/TimeRange.h"

#include <algorithm>

namespace voxeland
{
namespace
{
constexpr size_t REMEMBERED = 4;
constexpr double OUT_OF_ORDER = 0.1;  // [s]
}  // namespace

uint32_t RecordingClock::recordingOf(Stream stream, const mrpt::Clock::time_point& time)
{
    auto* latest = &m_latest.at(static_cast<size_t>(stream));
    if (latest->size() > 1) {
        const auto [least, greatest] = std::minmax_element(latest->begin(), latest->end());
        if (time <= *least && secondsBetween(time, *greatest) > OUT_OF_ORDER) {
            ++m_recording;
            m_latest = {};
        }
    }
    latest->push_back(time);
    if (latest->size() > REMEMBERED) latest->pop_front();
    return m_recording;
}
}  // namespace voxeland
