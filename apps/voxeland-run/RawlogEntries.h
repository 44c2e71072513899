// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "files/GzInputFile.h"
#include "voxeland/rawlogs/PredictionSidecar.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <deque>
#include <optional>
#include <string>

namespace voxeland::apps
{
/** Reads a rawlog as MRPT's applications do, but with what lies beside it: predictions of the
 * sidecar come as if they were in the rawlog, after their scan, and
 * external images are found. Unlike MRPT's own reading it does not take damage for the end. */
class RawlogEntries
{
 public:
    /** Either an observation, or what the robot did and then saw. */
    struct Entry
    {
        mrpt::obs::CActionCollection::Ptr actions;
        mrpt::obs::CSensoryFrame::Ptr frame;
        mrpt::obs::CObservation::Ptr observation;
    };

    /** \param trustsPaths see checkImagePaths() \throws InputError if a file cannot be opened */
    RawlogEntries(const std::string& file, bool trustsPaths);

    /** The next entry, or none at the end.
     *  \throws InputError, naming the file, if it is cut off or damaged, or holds a class that is
     *  unknown; also as checkImagePaths() */
    std::optional<Entry> next();

    /** Objects read from the rawlog so far, which is how MRPT numbers entries; predictions of the
     * sidecar do not count. */
    [[nodiscard]] size_t objectsRead() const { return m_objectsRead; }

 private:
    /** Has the predictions of an observation come next, if it is a scan. */
    void meet(const mrpt::obs::CObservation& observation);

    std::string m_file;
    bool m_trustsPaths;
    GzInputFile m_rawlog;
    PredictionSidecar m_sidecar;
    std::deque<CObservationInstances::Ptr> m_predictions;  //!< of the scans met, to come next
    uint32_t m_scans = 0;
    size_t m_objectsRead = 0;
};
}  // namespace voxeland::apps
