// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/Scene.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <mrpt/math/TPose3D.h>

#include <vector>

namespace voxeland::simulation
{
/** Poses of a camera that somebody carries through all rooms, from one viewpoint to the next,
 *  looking at the furniture. */
class CameraPath
{
 public:
    CameraPath(const Scene& scene, const CameraOptions& options, Random random);

    /** True poses in the world, x forward, z up; one for each frame. */
    [[nodiscard]] const std::vector<mrpt::math::TPose3D>& poses() const { return m_poses; }

 private:
    std::vector<mrpt::math::TPose3D> m_poses;
};
}  // namespace voxeland::simulation
