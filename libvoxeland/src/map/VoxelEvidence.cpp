// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/VoxelEvidence.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voxeland
{
static_assert(sizeof(VoxelEvidence) == 40, "the memory budget of a surface voxel counts on it");

VoxelEvidence::VoxelEvidence(const VoxelEvidence& other)
    : m_size(other.m_size), m_capacity(other.m_capacity), m_data(other.m_data)
{
    if (m_capacity <= INLINE) return;
    m_data.heap = new Entry[m_capacity];
    std::copy(other.begin(), other.end(), m_data.heap);
}

VoxelEvidence::VoxelEvidence(VoxelEvidence&& other) noexcept
    : m_size(std::exchange(other.m_size, 0)),
      m_capacity(std::exchange(other.m_capacity, INLINE)),
      m_data(other.m_data)
{
}

VoxelEvidence& VoxelEvidence::operator=(VoxelEvidence other) noexcept
{
    std::swap(m_size, other.m_size);
    std::swap(m_capacity, other.m_capacity);
    std::swap(m_data, other.m_data);
    return *this;
}

VoxelEvidence::~VoxelEvidence()
{
    if (m_capacity > INLINE) delete[] m_data.heap;
}

bool VoxelEvidence::add(instance_id_t instance, float alpha)
{
    Entry* at = std::lower_bound(data(), data() + m_size, instance,
                                 [](const Entry& e, instance_id_t id) { return e.instance < id; });
    if (at != data() + m_size && at->instance == instance) {
        at->alpha = std::min(at->alpha + alpha, std::numeric_limits<float>::max());
        return false;
    }
    const auto position = at - data();
    if (m_size == m_capacity) grow();
    at = data() + position;
    std::move_backward(at, data() + m_size, data() + m_size + 1);
    *at = {instance, alpha};
    ++m_size;
    return true;
}

float VoxelEvidence::remove(instance_id_t instance)
{
    Entry* last = data() + m_size;
    Entry* at = std::find_if(data(), last, [&](const Entry& e) { return e.instance == instance; });
    if (at == last) return 0;
    const float alpha = at->alpha;
    std::move(at + 1, last, at);
    --m_size;
    return alpha;
}

float VoxelEvidence::alphaOf(instance_id_t instance) const
{
    for (const Entry& e : *this)
        if (e.instance == instance) return e.alpha;
    return 0;
}

float VoxelEvidence::total() const
{
    float sum = 0;
    for (const Entry& e : *this) sum += e.alpha;
    return sum;
}

float VoxelEvidence::membershipThreshold(double share) const
{
    float known = 0;
    for (const Entry& e : *this)
        if (e.instance != UNKNOWN_INSTANCE) known += e.alpha;
    return static_cast<float>(share) * known;
}

instance_id_t VoxelEvidence::strongest() const
{
    Entry best;
    for (const Entry& e : *this) {
        const bool beatsUnknown = best.instance == UNKNOWN_INSTANCE && e.alpha >= best.alpha;
        if (e.alpha > best.alpha || beatsUnknown) best = e;
    }
    return best.instance;
}

void VoxelEvidence::grow()
{
    const uint32_t capacity = 2 * m_capacity;
    auto* larger = new Entry[capacity];
    std::copy(begin(), end(), larger);
    if (m_capacity > INLINE) delete[] m_data.heap;
    m_data.heap = larger;
    m_capacity = capacity;
}
}  // namespace voxeland
