// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/RawlogPredictions.h"

#include <cstdint>
#include <fstream>
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
    UnfinishedPredictions(std::string file, const std::string& origin);

    /** Frames that were looked at before. */
    [[nodiscard]] size_t frames() const { return m_frames; }

    /** The predictions for a frame: those kept, or what `source` says, which is kept. Frames must
     * be asked for in order, from 0. \throws OutputError if they cannot be kept */
    CObservationInstances::Ptr of(size_t frame, const mrpt::obs::CObservation3DRangeScan& scan,
                                  const PredictionSource& source);

    /** Removes the file: everything is done. */
    void discard();

 private:
    CObservationInstances::Ptr nextKept();
    void keep(const CObservationInstances* predictions);

    std::string m_file;
    size_t m_frames = 0;
    std::ifstream m_kept;
    std::ofstream m_new;
};
}  // namespace voxeland
