// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/Opinion.h"
#include "voxeland/observations/RgbdFrame.h"
#include "voxeland/observations/VoxelizedFrame.h"
#include "voxeland/plugins/Plugin.h"

#include <memory>
#include <vector>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
inline namespace VOXELAND_PLUGIN_ABI
{
/** Base of the plugins that turn a frame into subjective opinions (paper, "Making Subjective
 * Opinions from 2D Semantic Instances"). Chosen in section [converter] of the INI. */
class COpinionConverter : public Plugin
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(COpinionConverter)

 public:
    /** Whether the class makes predictions itself, from what a scan holds; where not, those
     * recorded in the rawlog are used. */
    [[nodiscard]] virtual bool makesPredictions() const { return false; }

    /** The class's own predictions for a scan, without timestamp, label and sensor pose; they
     * become the frame's before convert(). Called if makesPredictions(), ahead of mapping, for one
     * frame after another.
     *  \return null if the scan holds nothing to make them from, and may be mapped without
     *  \throws InputError, naming the frame, if it lacks what is needed */
    [[nodiscard]] virtual std::shared_ptr<CObservationInstances> predict(
        const mrpt::obs::CObservation3DRangeScan&) const
    {
        return nullptr;
    }

    /** The opinions a frame holds, in a deterministic order. Called from several threads at a time.
     *  \param frame images, predictions and pose
     *  \param voxels its depth pixels grouped by voxel
     *  \throws InputError, naming the frame, if what it holds cannot be used */
    [[nodiscard]] virtual std::vector<Opinion> convert(const RgbdFrame& frame,
                                                       const VoxelizedFrame& voxels) const = 0;
};
}  // namespace VOXELAND_PLUGIN_ABI
}  // namespace voxeland
