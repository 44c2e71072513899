// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/LaserScanner.h"

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
LaserScanner::LaserScanner(const Scene& scene, const RobotOptions& options)
    : m_scene(scene), m_options(options)
{
    for (size_t i = 0; i < scene.parts().size(); ++i) {
        const Bounds& bounds = scene.parts()[i].solid.bounds();
        if (bounds.min.z <= options.laserHeight && bounds.max.z >= options.laserHeight)
            m_parts.push_back(i);
    }
}

std::vector<float> LaserScanner::measure(const mrpt::math::TPose2D& robot, Random& noise) const
{
    const Vector3 origin{static_cast<float>(robot.x), static_cast<float>(robot.y),
                         m_options.laserHeight};
    const double aperture = mrpt::DEG2RAD(static_cast<double>(m_options.laserAperture));
    std::vector<float> ranges;
    for (int i = 0; i < m_options.laserRays; ++i) {
        const double angle = robot.phi + aperture * (i / (m_options.laserRays - 1.0) - 0.5);
        const Vector3 ray{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                          0};
        float range = m_options.laserMaxRange;
        for (const size_t part : m_parts)
            if (const auto hit = m_scene.parts()[part].solid.intersect(origin, ray))
                range = std::min(range, *hit);
        const float error = noise.normal(m_options.laserSigma);
        ranges.push_back(range < m_options.laserMaxRange ? std::max(range + error, 0.0F) : 0);
    }
    return ranges;
}
}  // namespace voxeland::simulation
