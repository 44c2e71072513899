// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/CoordHash.h"

#include <algorithm>
#include <deque>
#include <numeric>
#include <vector>

namespace voxeland
{
/** Sparse storage: one Block per 8x8x8 voxels that anything is known of.
 *  References stay valid until clear(); blocks are numbered in order of creation. */
template <typename Block>
class BlockMap
{
 public:
    [[nodiscard]] const Block* find(const VoxelCoord& block) const
    {
        const uint32_t i = m_index.find(block);
        return i == CoordHash::NONE ? nullptr : &m_blocks[i];
    }
    [[nodiscard]] Block* find(const VoxelCoord& block)
    {
        const uint32_t i = m_index.find(block);
        return i == CoordHash::NONE ? nullptr : &m_blocks[i];
    }
    /** The block at these block coordinates, made empty if there is none. */
    Block& at(const VoxelCoord& block) { return m_blocks[indexAt(block)]; }

    /** Like at(), but gives the block's number. */
    uint32_t indexAt(const VoxelCoord& block)
    {
        const auto next = static_cast<uint32_t>(m_blocks.size());
        const uint32_t i = m_index.insert(block, next);
        if (i == next) {
            m_blocks.emplace_back();
            m_coords.push_back(block);
        }
        return i;
    }

    [[nodiscard]] size_t size() const { return m_blocks.size(); }
    [[nodiscard]] Block& operator[](size_t i) { return m_blocks[i]; }
    [[nodiscard]] const Block& operator[](size_t i) const { return m_blocks[i]; }
    [[nodiscard]] const VoxelCoord& coordOf(size_t i) const { return m_coords[i]; }

    /** Block numbers ordered by coordinates: the same for the same content, however it came. */
    [[nodiscard]] std::vector<uint32_t> sorted() const
    {
        std::vector<uint32_t> order(m_blocks.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [this](uint32_t a, uint32_t b) { return m_coords[a] < m_coords[b]; });
        return order;
    }

    void clear()
    {
        m_index.clear();
        m_blocks.clear();
        m_coords.clear();
    }

    /** Heap memory in use, allocator overhead included, without what blocks own [bytes]. */
    [[nodiscard]] size_t memory() const
    {
        constexpr size_t MALLOC_HEADER = 16;
        return m_index.memory() +
               m_blocks.size() * (sizeof(Block) + MALLOC_HEADER + sizeof(void*)) +
               m_coords.capacity() * sizeof(VoxelCoord);
    }

 private:
    CoordHash m_index;
    std::deque<Block> m_blocks;
    std::vector<VoxelCoord> m_coords;
};
}  // namespace voxeland
