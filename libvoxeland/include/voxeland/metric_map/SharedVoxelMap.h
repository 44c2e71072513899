// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/metric_map/DistanceField.h"

#include <memory>
#include <mutex>
#include <optional>

namespace mrpt::maps
{
class CSimplePointsMap;
}

namespace voxeland
{
class PointsSlice;

/** A semantic voxel map that copies share until one of them is changed, and what is derived from
 * its occupied voxels, made when first asked for. Copies may be used in different threads. */
class SharedVoxelMap
{
 public:
    SharedVoxelMap();
    // No moving: what was moved from would be without a map.
    SharedVoxelMap(const SharedVoxelMap&) = default;
    SharedVoxelMap& operator=(const SharedVoxelMap&) = default;
    ~SharedVoxelMap() = default;

    const SemanticVoxelMap& operator*() const { return m_content->map; }
    const SemanticVoxelMap* operator->() const { return &m_content->map; }

    /** To change the map: it is copied first if others share it. The reference must not be kept
     * until after the next copy, nor until after points(), withSlice() or withDistances(): what
     * they derive from the map would not follow it. */
    SemanticVoxelMap& edit();

    /** Centres of occupied voxels in the map's frame [m]; valid until the map changes. */
    [[nodiscard]] const mrpt::maps::CSimplePointsMap& points() const;

    /** Calls f(const PointsSlice&) with the centres of certain heights, one thread at a time. The
     * last slice is kept: whoever aligns a scan asks for the same one again and again. f must not
     * use this map: it would wait for itself. \param lowest, highest [m] */
    template <typename F>
    void withSlice(float lowest, float highest, F&& f) const
    {
        const std::lock_guard<std::mutex> lock(m_content->mutex);
        f(m_content->sliceOf(lowest, highest));
    }

    /** Calls f(DistanceField&), one thread at a time. \param reach of the field [m] */
    template <typename F>
    auto withDistances(double reach, F&& f) const
    {
        const std::lock_guard<std::mutex> lock(m_content->mutex);
        auto& field = m_content->distances;
        if (!field || field->reach() != reach) field.emplace(m_content->map, reach);
        return f(*field);
    }

 private:
    struct Content
    {
        explicit Content(const SemanticVoxelMap& m) : map(m) {}

        // Those who call them hold the mutex.
        const mrpt::maps::CSimplePointsMap& allPoints();
        const PointsSlice& sliceOf(float lowest, float highest);

        SemanticVoxelMap map;
        std::mutex mutex;  //!< of what follows
        std::shared_ptr<mrpt::maps::CSimplePointsMap> points;
        std::shared_ptr<const PointsSlice> slice;
        std::optional<DistanceField> distances;
    };
    std::shared_ptr<Content> m_content;
};
}  // namespace voxeland
