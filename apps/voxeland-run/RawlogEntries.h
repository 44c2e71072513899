// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/io/GzInputFile.h"
#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace voxeland::apps
{
/** Reads a rawlog as MRPT's applications do, but with what lies beside it: predictions of the
 * sidecar come as if they were in the rawlog, after the scans they belong to, and external images
 * are found. Unlike MRPT's own reading it does not take damage for the end. */
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

    /** \throws InputError if a file cannot be opened */
    explicit RawlogEntries(const std::string& file);

    /** The next entry, or none at the end.
     *  \throws InputError, naming the file, if it is cut off or damaged, or holds a class that is
     *  unknown */
    std::optional<Entry> next();

 private:
    /** Predictions of the sidecar for a scan, or null. */
    CObservationInstances::Ptr predictionsFor(const mrpt::obs::CObservation& observation);

    GzInputFile m_rawlog;
    std::unique_ptr<GzInputFile> m_sidecar;
    CObservationInstances::Ptr m_nextOfSidecar;
    mrpt::obs::CObservation::Ptr m_pending;  //!< predictions for the observation just returned
};
}  // namespace voxeland::apps
