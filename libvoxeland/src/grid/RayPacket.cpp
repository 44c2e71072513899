// SPDX-License-Identifier: BSD-3-Clause
#include "RayPacket.h"

#include "base/vectorized.h"

namespace voxeland
{
namespace
{
/** All bits set, or none. */
uint64_t maskOf(bool condition)
{
    return -static_cast<uint64_t>(condition);
}

bool isBefore(uint64_t a, uint64_t b)
{
    return static_cast<int64_t>(a) < static_cast<int64_t>(b);
}
}  // namespace

void RayPacket::set(size_t number, const GridRay& ray, uint64_t key)
{
    for (size_t a = 0; a < 3; ++a) {
        m_next[a][number] = static_cast<uint64_t>(ray.next[a]);
        m_delta[a][number] = static_cast<uint64_t>(ray.delta[a]);
        m_step[a][number] = static_cast<uint64_t>(ray.step[a]) << (PACKED_BITS * a);
    }
    m_key[number] = key;
}

VOXELAND_WITH_AVX2 void RayPacket::walk(size_t steps, uint64_t* __restrict keys)
{
    auto& [nextX, nextY, nextZ] = m_next;
    for (size_t s = 0; s < steps; ++s, keys += RAYS)
        for (size_t r = 0; r < RAYS; ++r) {
            const uint64_t x =
                maskOf(isBefore(nextX[r], nextY[r])) & ~maskOf(isBefore(nextZ[r], nextX[r]));
            const uint64_t y = ~x & ~maskOf(isBefore(nextZ[r], nextY[r]));
            const uint64_t z = ~(x | y);
            nextX[r] += x & m_delta[0][r];
            nextY[r] += y & m_delta[1][r];
            nextZ[r] += z & m_delta[2][r];
            keys[r] = m_key[r];
            m_key[r] += (x & m_step[0][r]) + (y & m_step[1][r]) + (z & m_step[2][r]);
        }
}
}  // namespace voxeland
