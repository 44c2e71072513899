// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/PoseUncertainty.h"
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <mrpt/math/TPose3D.h>

#include <vector>

namespace voxeland::simulation
{
/** A pose that a localization reports. */
struct ReportedPose
{
    mrpt::math::TPose3D pose;
    PoseCovariance covariance;  //!< what its errors really are, to first order; null: it is exact
};

/** The poses that a localization with errors would report: a random walk away from the true ones.
 */
[[nodiscard]] std::vector<ReportedPose> drifting(const std::vector<mrpt::math::TPose3D>& poses,
                                                 const DriftOptions& options, Random random);

/** Gives each pose an error of its own. */
[[nodiscard]] std::vector<ReportedPose> jittering(std::vector<ReportedPose> poses,
                                                  const JitterOptions& options, Random random);
}  // namespace voxeland::simulation
