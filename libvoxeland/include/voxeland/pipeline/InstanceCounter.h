// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/VoxelEvidence.h"

#include <algorithm>
#include <vector>

namespace voxeland
{
/** Counts per instance; a count costs an array access, clearing only what was counted. */
class InstanceCounter
{
 public:
    void add(instance_id_t id)
    {
        if (id >= m_count.size()) m_count.resize(std::max<size_t>(2 * m_count.size(), id + 1), 0);
        if (m_count[id]++ == 0) m_counted.push_back(id);
    }
    [[nodiscard]] uint32_t of(instance_id_t id) const
    {
        return id < m_count.size() ? m_count[id] : 0;
    }
    /** Ids with a count, in increasing order. */
    [[nodiscard]] const std::vector<instance_id_t>& counted()
    {
        std::sort(m_counted.begin(), m_counted.end());
        return m_counted;
    }
    void clear()
    {
        for (const instance_id_t id : m_counted) m_count[id] = 0;
        m_counted.clear();
    }

 private:
    std::vector<uint32_t> m_count;
    std::vector<instance_id_t> m_counted;
};
}  // namespace voxeland
