// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/errors.h"

#include <cmath>
#include <string>

namespace voxeland
{
/** A coordinate as a float, where that is exact to a tenth of a voxel.
 *  \param metres in the world \param resolution voxel edge [m] \param format what holds floats
 * alone, such as "a gridmap" \throws ConfigurationError elsewhere */
inline float asFloat(double metres, double resolution, const std::string& format)
{
    const auto value = static_cast<float>(metres);
    if (std::abs(static_cast<double>(value) - metres) > resolution / 10)
        throw ConfigurationError(format +
                                 " lacks the digits for coordinates that far from the origin of "
                                 "the world: use --ply, --ros-map or --glb");
    return value;
}
}  // namespace voxeland
