// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/SharedVoxelMap.h"

#include "PointsSlice.h"

#include <atomic>

namespace voxeland
{
SharedVoxelMap::SharedVoxelMap() : m_content(std::make_shared<Content>(SemanticVoxelMap())) {}

SemanticVoxelMap& SharedVoxelMap::edit()
{
    if (m_content.use_count() > 1) {
        m_content = std::make_shared<Content>(m_content->map);
    } else {
        // What other threads read of it, before they let go of it, was read before.
        std::atomic_thread_fence(std::memory_order_acquire);
        m_content->points.reset();
        m_content->slice.reset();
        m_content->distances.reset();
    }
    return m_content->map;
}

const mrpt::maps::CSimplePointsMap& SharedVoxelMap::points() const
{
    const std::lock_guard<std::mutex> lock(m_content->mutex);
    return m_content->allPoints();
}

const mrpt::maps::CSimplePointsMap& SharedVoxelMap::Content::allPoints()
{
    if (!points) {
        points = std::make_shared<mrpt::maps::CSimplePointsMap>();
        map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence&) {
            const auto p = voxelCenter<mrpt::math::TPoint3Df>(v, map.resolution());
            points->insertPoint(p.x, p.y, p.z);
        });
        (void)points->boundingBox();  // MRPT keeps the box without a lock once it is known.
    }
    return *points;
}

const PointsSlice& SharedVoxelMap::Content::sliceOf(float lowest, float highest)
{
    if (!slice || slice->lowest() != lowest || slice->highest() != highest)
        slice = std::make_shared<PointsSlice>(allPoints(), lowest, highest);
    return *slice;
}
}  // namespace voxeland
