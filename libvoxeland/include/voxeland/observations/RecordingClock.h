// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>

#include <array>
#include <cstdint>
#include <deque>

namespace voxeland
{
/** Tells the recordings of a rawlog apart: where the time of a stream goes back, to before its
 *  last few observations and by more than observations come out of order, another one begins. */
class RecordingClock
{
 public:
    enum class Stream
    {
        poses,
        scans,
        predictions,
        count
    };

    /** Which recording, counted from 0, the next observation of a stream belongs to. */
    uint32_t recordingOf(Stream stream, const mrpt::Clock::time_point& time);

 private:
    using Times = std::deque<mrpt::Clock::time_point>;

    /** The last ones of each stream in this recording. */
    std::array<Times, static_cast<size_t>(Stream::count)> m_latest;
    uint32_t m_recording = 0;
};
}  // namespace voxeland
