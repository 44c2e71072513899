// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"

#include <cstddef>
#include <vector>

namespace voxeland
{
/** Hash table from coordinates to numbers: open addressing with linear probing, at most half full.
 *  Lookups are what ray casting and clustering spend their time on, hence not std::unordered_map.
 */
class CoordHash
{
 public:
    static constexpr uint32_t NONE = 0xFFFFFFFFu;

    /** The number stored for `c`, or NONE. */
    [[nodiscard]] uint32_t find(const VoxelCoord& c) const
    {
        if (m_slots.empty()) return NONE;
        return m_slots[slotOf(packed(c))].value;
    }

    /** Stores `value` for `c` unless there is one already. \return the number stored now */
    uint32_t insert(const VoxelCoord& c, uint32_t value)
    {
        if (2 * (m_size + 1) > m_slots.size()) grow();
        Slot& slot = m_slots[slotOf(packed(c))];
        if (slot.value == NONE) {
            slot = {packed(c), value};
            ++m_size;
        }
        return slot.value;
    }

    [[nodiscard]] size_t size() const { return m_size; }
    /** Makes room for `n` coordinates at once. */
    void reserve(size_t n)
    {
        while (2 * n > m_slots.size()) grow();
    }
    void clear()
    {
        m_slots.clear();
        m_size = 0;
    }
    /** Slots that find() looks at for a coordinate that is there, on average; 1: none collide. */
    [[nodiscard]] double meanProbes() const
    {
        size_t probes = 0;
        for (size_t i = 0; i < m_slots.size(); ++i)
            if (m_slots[i].value != NONE)
                probes += ((i - homeOf(m_slots[i].key)) & (m_slots.size() - 1)) + 1;
        return m_size == 0 ? 1 : static_cast<double>(probes) / static_cast<double>(m_size);
    }
    /** Heap memory in use [bytes]. */
    [[nodiscard]] size_t memory() const { return m_slots.capacity() * sizeof(Slot); }

 private:
    struct Slot
    {
        uint64_t key = 0;
        uint32_t value = NONE;
    };

    static constexpr size_t FEWEST = 64;
    static constexpr int FEWEST_SHIFT = 64 - 6;  //!< leaves log2(FEWEST) bits

    /** Where the key is looked for first. */
    [[nodiscard]] size_t homeOf(uint64_t key) const
    {
        return static_cast<size_t>((key * 0xD6E8FEB86659FD93ull) >> m_shift);
    }

    /** Where the key is, or the empty slot where it belongs. */
    [[nodiscard]] size_t slotOf(uint64_t key) const
    {
        const size_t mask = m_slots.size() - 1;
        size_t i = homeOf(key);
        while (m_slots[i].value != NONE && m_slots[i].key != key) i = (i + 1) & mask;
        return i;
    }

    void grow()
    {
        std::vector<Slot> old(m_slots.empty() ? FEWEST : 2 * m_slots.size());
        m_shift = m_slots.empty() ? FEWEST_SHIFT : m_shift - 1;
        old.swap(m_slots);
        for (const Slot& s : old)
            if (s.value != NONE) m_slots[slotOf(s.key)] = s;
    }

    std::vector<Slot> m_slots;
    size_t m_size = 0;
    int m_shift = FEWEST_SHIFT;  //!< leaves the top bits of a product, which all of the key reach
};
}  // namespace voxeland
