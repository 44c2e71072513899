// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/CObservationInstances.h"

#include <mrpt/core/Clock.h>

#include <memory>

namespace voxeland
{
class GzInputFile;
struct RawlogFiles;

/** Reads the predictions that lie beside a rawlog, as a stream, along with its scans. */
class PredictionSidecar
{
 public:
    /** A rawlog may have no sidecar: there are no predictions then.
     *  \throws InputError if there is one that cannot be opened */
    explicit PredictionSidecar(const RawlogFiles& files);
    ~PredictionSidecar();

    /** The next predictions in the file, of whichever detector, or null if they are of a time later
     *  than this, or none are left.
     *  \throws InputError, naming the file, if it is cut off or damaged */
    CObservationInstances::Ptr next(const mrpt::Clock::time_point& until);

 private:
    std::unique_ptr<GzInputFile> m_input;  //!< null: read to the end
    CObservationInstances::Ptr m_later;    //!< read already
};
}  // namespace voxeland
