// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/level/GravityAlignedFrame.h"

#include <string>

namespace voxeland
{
/** A picture of an instance's voxels, orange, amid what surrounds it: other objects bluish, the
 * rest grey; what stands in front of it is translucent. From above the corner that shows it best.
 *  \param frame in which up is z \param height of the picture, which is a third wider [pixels]
 *  \return a PNG file; empty if the instance has no occupied voxel */
std::string instancePicture(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                            instance_id_t instance, int height);
}  // namespace voxeland
