// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/Scene.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <mrpt/math/TPose2D.h>

#include <vector>

namespace voxeland::simulation
{
/** A level 2D laser scanner over the middle of a robot. */
class LaserScanner
{
 public:
    /** Keeps a reference to the scene. */
    LaserScanner(const Scene& scene, const RobotOptions& options);

    /** Ranges [m] of all rays, from the rightmost to the leftmost; 0: nothing within reach.
     *  Safe to call from several threads. \param robot its place on the floor */
    [[nodiscard]] std::vector<float> measure(const mrpt::math::TPose2D& robot, Random& noise) const;

 private:
    const Scene& m_scene;
    RobotOptions m_options;
    std::vector<size_t> m_parts;  //!< of the scene, those that reach the laser's height
};
}  // namespace voxeland::simulation
