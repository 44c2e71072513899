// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"
#include "voxeland/observations/RecordingClock.h"
#include "voxeland/observations/TimeRange.h"

#include <mrpt/core/Clock.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace voxeland
{
class GzInputFile;
struct RawlogFiles;

/** Gives each scan of a rawlog its predictions out of the file beside it, which is read as a stream
 *  along with the scans: predictions lie there in the scans' order, or nearly. Where time goes
 *  back, in both files, another recording begins; of equal times, the first prediction is the first
 *  scan's. */
class PredictionSidecar
{
 public:
    using Filter = std::function<bool(const CObservationInstances&)>;
    using LeftOver = std::function<void(uint32_t frame)>;

    /** A rawlog may have no sidecar: there are no predictions then.
     *  \param isWanted which predictions to use; others are passed over
     *  \param leftOver told of predictions that belong to no scan, with the number of the first
     *  scan behind them
     *  \throws InputError if there is one that cannot be opened */
    PredictionSidecar(const RawlogFiles& files, Filter isWanted, LeftOver leftOver);
    ~PredictionSidecar();

    /** The predictions of the next scan, or null. \param frame the scan's number
     *  \throws InputError, naming the file, if it is cut off or damaged */
    CObservationInstances::Ptr of(const mrpt::Clock::time_point& scan, uint32_t frame);
    /** There are no more scans: what was read and is not a scan's is left over: before the scan
     * that passed it over, or else before this frame. \param toTheEnd reads what remains, too */
    void finish(uint32_t frame, bool toTheEnd);

    /** Times of all predictions that were read. */
    [[nodiscard]] const TimeRange& times() const { return m_times; }

 private:
    struct Ahead
    {
        CObservationInstances::Ptr predictions;
        bool goesBack;  //!< in time: maybe the first one of another recording
        std::optional<uint32_t> passedBy = std::nullopt;  //!< number of the first scan after it
    };

    bool readOne();
    /** Drops what is left of the recording before, now that the scans' time has gone back. */
    void startRecording(uint32_t frame);
    /** Whether predictions read ahead are for a recording whose scans have not begun. */
    bool beginsRecording(size_t index, const mrpt::Clock::time_point& scan);
    void dropPassed(uint32_t frame);
    void drop(size_t index, uint32_t frame);

    std::unique_ptr<GzInputFile> m_input;  //!< null: read to the end
    Filter m_isWanted;
    LeftOver m_leftOver;
    std::deque<Ahead> m_ahead;
    RecordingClock m_clock, m_scanClock;
    uint32_t m_recording = 0, m_scanRecording = 0;
    TimeRange m_scans;  //!< of the recording
    TimeRange m_times;
};
}  // namespace voxeland
