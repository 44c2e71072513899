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
    /** Heap memory in use [bytes]. */
    [[nodiscard]] size_t memory() const { return m_slots.capacity() * sizeof(Slot); }

 private:
    struct Slot
    {
        uint64_t key = 0;
        uint32_t value = NONE;
    };

    /** Where the key is, or the empty slot where it belongs. */
    [[nodiscard]] size_t slotOf(uint64_t key) const
    {
        const size_t mask = m_slots.size() - 1;
        size_t i = static_cast<size_t>((key * 0x9E3779B97F4A7C15ull) >> 32) & mask;
        while (m_slots[i].value != NONE && m_slots[i].key != key) i = (i + 1) & mask;
        return i;
    }

    void grow()
    {
        std::vector<Slot> old(m_slots.empty() ? 64 : 2 * m_slots.size());
        old.swap(m_slots);
        for (const Slot& s : old)
            if (s.value != NONE) m_slots[slotOf(s.key)] = s;
    }

    std::vector<Slot> m_slots;
    size_t m_size = 0;
};
}  // namespace voxeland
