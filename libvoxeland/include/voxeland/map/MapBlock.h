// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/evidence/OccupancyFilter.h"
#include "voxeland/grid/CellMask.h"
#include "voxeland/map/VoxelEvidence.h"

#include <array>
#include <vector>

namespace voxeland
{
/** What a map knows of 8x8x8 voxels: occupancy of each, and evidence for instances where points
 *  were measured (surface voxels), packed in cell order. A voxel known only to be free costs two
 *  bytes plus its share of the block. */
class MapBlock
{
 public:
    MapBlock() { m_occupancy.fill(UNOBSERVED); }

    [[nodiscard]] log_odds_t occupancy(int cell) const
    {
        return m_occupancy[static_cast<size_t>(cell)];
    }
    void setOccupancy(int cell, log_odds_t value)
    {
        m_occupancy[static_cast<size_t>(cell)] = value;
    }

    /** Cells that have evidence. */
    [[nodiscard]] const CellMask& surface() const { return m_surface; }
    /** Evidence of a cell, or null. */
    [[nodiscard]] const VoxelEvidence* evidence(int cell) const
    {
        return m_surface.test(cell) ? &m_evidence[static_cast<size_t>(m_surface.rank(cell))]
                                    : nullptr;
    }
    [[nodiscard]] VoxelEvidence* evidence(int cell)
    {
        return m_surface.test(cell) ? &m_evidence[static_cast<size_t>(m_surface.rank(cell))]
                                    : nullptr;
    }
    /** Evidence of a cell, made empty where there is none; invalidates references to the block's
     *  other evidence. */
    VoxelEvidence& evidenceAt(int cell);

    /** Calls f(cell, evidence) for each surface cell in increasing order. */
    template <typename F>
    void forEachSurface(F&& f) const
    {
        size_t i = 0;
        m_surface.forEach([&](int cell) { f(cell, m_evidence[i++]); });
    }
    template <typename F>
    void forEachSurface(F&& f)
    {
        size_t i = 0;
        m_surface.forEach([&](int cell) { f(cell, m_evidence[i++]); });
    }

    /** Number of cells ever observed. */
    [[nodiscard]] int observedCells() const;
    /** Heap memory of the evidence, allocator overhead included [bytes]. */
    [[nodiscard]] size_t heapMemory() const;

 private:
    std::array<log_odds_t, BLOCK_CELLS> m_occupancy;
    CellMask m_surface;
    std::vector<VoxelEvidence> m_evidence;
};
}  // namespace voxeland
