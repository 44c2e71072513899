// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/Opinion.h"
#include "voxeland/observations/RgbdFrame.h"
#include "voxeland/observations/VoxelizedFrame.h"
#include "voxeland/plugins/Plugin.h"

#include <vector>

namespace voxeland
{
inline namespace abi_1
{
/** Base of the plugins that turn a frame into subjective opinions (paper, "Making Subjective
 * Opinions from 2D Semantic Instances"). Chosen in section [converter] of the INI. */
class COpinionConverter : public Plugin
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(COpinionConverter)

 public:
    /** The opinions a frame holds, in a deterministic order. Called from several threads at a time.
     *  \param frame images, predictions and pose
     *  \param voxels its depth pixels grouped by voxel
     *  \throws InputError, naming the frame, if what it holds cannot be used */
    [[nodiscard]] virtual std::vector<Opinion> convert(const RgbdFrame& frame,
                                                       const VoxelizedFrame& voxels) const = 0;
};
}  // namespace abi_1
}  // namespace voxeland
