// SPDX-License-Identifier: BSD-3-Clause
/** How other maps fit a CVoxelandMap. */
#include "PointsSlice.h"
#include "voxeland/metric_map/CVoxelandMap.h"

#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose2D.h>

#include <stdexcept>

using mrpt::maps::CMetricMap;
using mrpt::maps::CPointsMap;
using mrpt::maps::CSimplePointsMap;
using mrpt::math::TPoint3D;
using mrpt::poses::CPose3D;

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

/** Pairs found in a map's frame; MRPT's pairs hold floats. */
void moveToWorld(mrpt::tfest::TMatchingPairList& pairs, const SemanticVoxelMap& map)
{
    const mrpt::math::TPoint3Df origin(map.origin());
    for (auto& pair : pairs) pair.global += origin;
}
}  // namespace

mrpt::math::TBoundingBoxf CVoxelandMap::boundingBox() const
{
    const auto& points = m_map.points();
    if (points.empty()) return {{0, 0, 0}, {0, 0, 0}};
    const auto half = static_cast<float>(m_map->resolution() / 2);
    const auto centers = points.boundingBox();
    const mrpt::math::TPoint3Df margin(half, half, half), origin(m_map->origin());
    return {centers.min - margin + origin, centers.max + margin + origin};
}

void CVoxelandMap::determineMatching3D(const CMetricMap* other,
                                       const mrpt::poses::CPose3D& otherPose,
                                       mrpt::tfest::TMatchingPairList& correspondences,
                                       const mrpt::maps::TMatchingParams& params,
                                       mrpt::maps::TMatchingExtraResults& results) const
{
    m_map.points().determineMatching3D(&pointsOf(*other), relativeTo(m_map->origin(), otherPose),
                                       correspondences, params, results);
    moveToWorld(correspondences, *m_map);
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
    const TPoint3D& origin = m_map->origin();
    const mrpt::poses::CPose2D pose(otherPose.x() - origin.x, otherPose.y() - origin.y,
                                    otherPose.phi());
    const auto match = [&](const PointsSlice& slice) {
        slice.points().determineMatching2D(&otherPoints, pose, correspondences, params, results);
        for (auto& pair : correspondences) pair.globalIdx = slice.indexInAll(pair.globalIdx);
    };
    const auto z = static_cast<float>(origin.z);
    m_map.withSlice(heights.min.z - z - half, heights.max.z - z + half, match);
    moveToWorld(correspondences, *m_map);
}

float CVoxelandMap::compute3DMatchingRatio(const CMetricMap* other,
                                           const mrpt::poses::CPose3D& otherPose,
                                           const mrpt::maps::TMatchingRatioParams& params) const
{
    const CPointsMap& otherPoints = pointsOf(*other);
    const CSimplePointsMap& points = m_map.points();
    if (points.empty() || otherPoints.empty()) return 0;
    const CPose3D pose = relativeTo(m_map->origin(), otherPose);
    size_t matched = 0;
    for (size_t i = 0; i < otherPoints.size(); ++i) {
        mrpt::math::TPoint3D inOther;
        otherPoints.getPoint(i, inOther);
        const mrpt::math::TPoint3Df p(pose.composePoint(inOther));
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
