// SPDX-License-Identifier: BSD-3-Clause
/** How well observations fit a CVoxelandMap. */
#include "observations/ObservedPoints.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <cmath>

namespace voxeland
{
bool CVoxelandMap::internal_canComputeObservationLikelihood(
    const mrpt::obs::CObservation& observation) const
{
    return hasPoints(observation);
}

double CVoxelandMap::internal_computeObservationLikelihood(
    const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& takenFrom) const
{
    const LikelihoodOptions& o = likelihoodOptions;
    const auto points = observedPoints(observation, o.max_points, o.max_range);
    const mrpt::poses::CPose3D sensed = relativeTo(m_map->origin(), takenFrom);
    const double exponent = -0.5 / (o.sigma_dist * o.sigma_dist);
    const double sum = m_map.withDistances(o.max_corr_distance, [&](DistanceField& field) {
        double logarithms = 0;
        for (const auto& p : points) {
            const double squared = field.squaredDistance(sensed.composePoint(p));
            logarithms += std::log((1 - o.outliers) * std::exp(exponent * squared) + o.outliers);
        }
        return logarithms;
    });
    if (o.independent_points == 0 || points.size() <= o.independent_points) return sum;
    return sum * o.independent_points / static_cast<double>(points.size());
}
}  // namespace voxeland
