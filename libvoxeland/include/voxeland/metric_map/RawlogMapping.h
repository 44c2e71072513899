// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/LeftOut.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/rawlogs/RawlogFrameSource.h"

#include <functional>

namespace voxeland
{
/** Whether the surfaces that frames measure are where those before them measured some. */
struct SurfaceAgreement
{
    uint64_t agreeing = 0;       //!< hit voxels that were occupied before
    uint64_t contradicting = 0;  //!< hit voxels that were free before

    /** Looks up some of the voxels that a frame hits, before it is mapped. */
    void add(const VoxelizedFrame& frame, const SemanticVoxelMap& map);
    [[nodiscard]] uint64_t known() const { return agreeing + contradicting; }
    /** Share of those known before that contradict, in [0,1]. */
    [[nodiscard]] double contradiction() const
    {
        return known() == 0 ? 0 : static_cast<double>(contradicting) / static_cast<double>(known());
    }
};

/** What mapRawlog() met. */
struct MappedInput
{
    LeftOut leftOut;           //!< frames without a usable depth image
    DepthsMet depths;          //!< of all frames mapped
    uint64_t predictions = 0;  //!< of the frames that have a pose
    uint64_t opinions = 0;     //!< that they became
    uint32_t repeated = 0;     //!< frames left out, as the map was made from them already
    SurfaceAgreement surfaces;
};

/** Maps all frames of a rawlog, which are read and prepared ahead in several threads. A frame
 *  whose depth image is missing, damaged or empty is left out, and so is one that the map holds().
 *  \param onFrame called after each frame with its stage times
 *  \param strict such a frame is an error instead
 *  \throws InputError as RawlogFrameSource and SemanticMapper do, and if no frame is usable;
 *  NothingToMapError if there is no frame with a pose, unless the source was stopped before it, or
 *  none with a depth within the limits. The map then holds the frames before. */
MappedInput mapRawlog(RawlogFrameSource& source, CVoxelandMap& map,
                      const std::function<void(const StageTimes&)>& onFrame, bool strict = false);
}  // namespace voxeland
