// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MapBlock.h"

#include <algorithm>

namespace voxeland
{
VoxelEvidence& MapBlock::evidenceAt(int cell)
{
    const auto rank = m_surface.rank(cell);
    if (!m_surface.test(cell)) {
        // Grow by a quarter, not by doubling: memory for a surface voxel is budgeted.
        if (m_evidence.size() == m_evidence.capacity())
            m_evidence.reserve(m_evidence.size() + m_evidence.size() / 4 + 4);
        m_evidence.insert(m_evidence.begin() + rank, VoxelEvidence());
        m_surface.set(cell);
    }
    return m_evidence[static_cast<size_t>(rank)];
}

int MapBlock::observedCells() const
{
    return static_cast<int>(BLOCK_CELLS -
                            std::count(m_occupancy.begin(), m_occupancy.end(), UNOBSERVED));
}

size_t MapBlock::heapMemory() const
{
    constexpr size_t MALLOC_HEADER = 16;
    size_t bytes = m_evidence.capacity() * sizeof(VoxelEvidence);
    if (bytes > 0) bytes += MALLOC_HEADER;
    for (const auto& e : m_evidence) bytes += e.heapMemory();
    return bytes;
}
}  // namespace voxeland
