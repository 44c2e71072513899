// SPDX-License-Identifier: BSD-3-Clause
/** How well observations and other maps fit a CVoxelandMap. */
#include "voxeland/metric_map/CVoxelandMap.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;

namespace voxeland
{
namespace
{
/** Points of a range scan in the robot's frame. */
mrpt::maps::CSimplePointsMap pointsOf(const CObservation& observation)
{
    mrpt::maps::CSimplePointsMap points;
    if (const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&observation)) {
        points.insertionOptions.minDistBetweenLaserPoints = 0;
        points.loadFromRangeScan(*scan);
    } else if (const auto* depth = dynamic_cast<const CObservation3DRangeScan*>(&observation)) {
        CObservation3DRangeScan copy(*depth);  // unprojecting writes into the observation
        copy.load();
        mrpt::obs::T3DPointsProjectionParams parameters;
        parameters.takeIntoAccountSensorPoseOnRobot = true;
        // MRPT wants a divisor of both sides of the image.
        parameters.decimation = static_cast<uint8_t>(
            std::gcd(8, std::gcd(copy.rangeImage.cols(), copy.rangeImage.rows())));
        copy.unprojectInto(points, parameters);
    }
    return points;
}

bool isOccupiedNear(const SemanticVoxelMap& map, const VoxelCoord& v)
{
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (OccupancyFilter::isOccupied(map.occupancy(v + VoxelCoord{dx, dy, dz})))
                    return true;
    return false;
}
}  // namespace

bool CVoxelandMap::internal_canComputeObservationLikelihood(const CObservation& observation) const
{
    return dynamic_cast<const CObservation2DRangeScan*>(&observation) != nullptr ||
           dynamic_cast<const CObservation3DRangeScan*>(&observation) != nullptr;
}

double CVoxelandMap::internal_computeObservationLikelihood(
    const CObservation& observation, const mrpt::poses::CPose3D& takenFrom) const
{
    constexpr double OUTLIERS = 0.05;
    double sum = 0;
    const auto points = pointsOf(observation);
    for (size_t i = 0; i < points.size(); ++i) {
        mrpt::math::TPoint3D local;
        points.getPoint(i, local);
        const log_odds_t value = m_map.occupancy(m_map.voxelOf(takenFrom.composePoint(local)));
        sum += std::log(OUTLIERS + (1 - OUTLIERS) * OccupancyFilter::probability(value));
    }
    return sum;
}

float CVoxelandMap::compute3DMatchingRatio(const mrpt::maps::CMetricMap* other,
                                           const mrpt::poses::CPose3D& otherPose,
                                           const mrpt::maps::TMatchingRatioParams&) const
{
    const auto* points = other->getAsSimplePointsMap();
    if (points == nullptr)
        throw std::runtime_error("a map without points cannot be matched with a voxeland map");
    if (points->empty()) return 0;
    size_t matched = 0;
    for (size_t i = 0; i < points->size(); ++i) {
        mrpt::math::TPoint3D local;
        points->getPoint(i, local);
        matched += isOccupiedNear(m_map, m_map.voxelOf(otherPose.composePoint(local))) ? 1 : 0;
    }
    return static_cast<float>(matched) / static_cast<float>(points->size());
}
}  // namespace voxeland
