// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/PoseAxes.h"

namespace voxeland
{
mrpt::poses::CPose3D poseOfAxes(PoseAxes axes)
{
    using namespace mrpt::literals;
    switch (axes) {
        case PoseAxes::optical:
            return {0, 0, 0, -90.0_deg, 0.0_deg, -90.0_deg};
        case PoseAxes::opengl:
            return {0, 0, 0, -90.0_deg, 0.0_deg, 90.0_deg};
        case PoseAxes::body:
            break;
    }
    return {};
}
}  // namespace voxeland
