// SPDX-License-Identifier: BSD-3-Clause
/** How other maps fit a CVoxelandMap. */
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/PointsSlice.h"

#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <stdexcept>

using mrpt::maps::CMetricMap;
using mrpt::maps::CPointsMap;
using mrpt::maps::CSimplePointsMap;

namespace voxeland
{
namespace
{
/** A map as points: what it is, what it can be seen as, or the CVoxelandMap among several maps. */
const CPointsMap& pointsOf(const CMetricMap& map)
{
    if (const auto* points = dynamic_cast<const CPointsMap*>(&map)) return *points;
    if (const auto* points = map.getAsSimplePointsMap()) return *points;
    if (const auto* several = dynamic_cast<const mrpt::maps::CMultiMetricMap*>(&map))
        if (const auto ours = several->mapByClass<CVoxelandMap>())
            return *std::as_const(*ours).getAsSimplePointsMap();
    throw std::runtime_error(std::string("a ") + map.GetRuntimeClass()->className +
                             " cannot be matched with a voxeland map: it has no points");
}
}  // namespace

mrpt::math::TBoundingBoxf CVoxelandMap::boundingBox() const
{
    const auto& points = m_map.points();
    if (points.empty()) return {{0, 0, 0}, {0, 0, 0}};
    const auto half = static_cast<float>(m_map->resolution() / 2);
    const auto centers = points.boundingBox();
    const mrpt::math::TPoint3Df margin(half, half, half);
    return {centers.min - margin, centers.max + margin};
}

void CVoxelandMap::determineMatching3D(const CMetricMap* other,
                                       const mrpt::poses::CPose3D& otherPose,
                                       mrpt::tfest::TMatchingPairList& correspondences,
                                       const mrpt::maps::TMatchingParams& params,
                                       mrpt::maps::TMatchingExtraResults& results) const
{
    m_map.points().determineMatching3D(&pointsOf(*other), otherPose, correspondences, params,
                                       results);
}

void CVoxelandMap::determineMatching2D(const CMetricMap* other,
                                       const mrpt::poses::CPose2D& otherPose,
                                       mrpt::tfest::TMatchingPairList& correspondences,
                                       const mrpt::maps::TMatchingParams& params,
                                       mrpt::maps::TMatchingExtraResults& results) const
{
    const CPointsMap& otherPoints = pointsOf(*other);
    const auto heights = otherPoints.boundingBox();
    const auto half = static_cast<float>(m_map->resolution() / 2);
    const auto match = [&](const PointsSlice& slice) {
        slice.points().determineMatching2D(&otherPoints, otherPose, correspondences, params,
                                           results);
        for (auto& pair : correspondences) pair.globalIdx = slice.indexInAll(pair.globalIdx);
    };
    m_map.withSlice(heights.min.z - half, heights.max.z + half, match);
}

float CVoxelandMap::compute3DMatchingRatio(const CMetricMap* other,
                                           const mrpt::poses::CPose3D& otherPose,
                                           const mrpt::maps::TMatchingRatioParams& params) const
{
    const CPointsMap& otherPoints = pointsOf(*other);
    const CSimplePointsMap& points = m_map.points();
    if (points.empty() || otherPoints.empty()) return 0;
    size_t matched = 0;
    for (size_t i = 0; i < otherPoints.size(); ++i) {
        mrpt::math::TPoint3D inOther;
        otherPoints.getPoint(i, inOther);
        const mrpt::math::TPoint3Df p(otherPose.composePoint(inOther));
        float x, y, z, squaredDistance;
        points.kdTreeClosestPoint3D(p.x, p.y, p.z, x, y, z, squaredDistance);
        if (squaredDistance <= params.maxDistForCorr * params.maxDistForCorr) ++matched;
    }
    return static_cast<float>(matched) / static_cast<float>(otherPoints.size());
}

float CVoxelandMap::squareDistanceToClosestCorrespondence(float, float) const
{
    throw std::logic_error(
        "a voxeland map cannot tell how near a point on the floor plan is: use "
        "determineMatching2D() or determineMatching3D()");
}
}  // namespace voxeland
