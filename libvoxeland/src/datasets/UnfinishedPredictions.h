// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "RawlogPredictions.h"
#include "files/RecordJournal.h"

#include <string>

namespace voxeland
{
/** What a network has said so far about the frames of a rawlog, in a file of its own: a run that
 * was stopped or killed leaves it, and the next one goes on from there. */
class UnfinishedPredictions
{
 public:
    /** Opens the file, or begins a new one where there is none of that origin.
     *  \param origin which network looks at which rawlog: only what has the same one is used
     *  \throws OutputError if it cannot be written */
    UnfinishedPredictions(const std::string& file, const std::string& origin);

    /** Frames that were looked at before. */
    [[nodiscard]] size_t frames() const { return m_journal.kept(); }

    /** The predictions for a frame: those kept, or what `source` says, which is kept. Frames must
     * be asked for in order, from 0. \throws OutputError if they cannot be kept */
    CObservationInstances::Ptr of(size_t frame, const mrpt::obs::CObservation3DRangeScan& scan,
                                  const PredictionSource& source);

    /** Removes the file: everything is done. */
    void discard() { m_journal.discard(); }

 private:
    CObservationInstances::Ptr nextKept();
    void keep(const CObservationInstances* predictions);

    RecordJournal m_journal;  //!< a record of each frame: an MRPT object, or nothing
};
}  // namespace voxeland
