// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "RayTraversal.h"

#include <array>

namespace voxeland
{
/** Walks many rays through voxels at once. The steps of one ray have to wait for one another;
 *  a step of all rays is a plain loop over arrays. */
class RayPacket
{
 public:
    static constexpr size_t RAYS = 16;

    /** Puts a ray in place of one of RAYS. \param key packed() coordinates of the ray's first
     * voxel, shifted so that none becomes negative on the way */
    void set(size_t number, const GridRay& ray, uint64_t key);

    /** Walks all rays on. Those that reach their end go on beyond it.
     *  \param keys keys[s * RAYS + r] receives where ray r was before its s-th step from now */
    void walk(size_t steps, uint64_t* keys);

 private:
    using Values = std::array<uint64_t, RAYS>;  // unsigned: they overflow far beyond a ray's end

    std::array<Values, 3> m_next{}, m_delta{};  //!< see GridRay
    std::array<Values, 3> m_step{};             //!< what a step along each axis adds to the key
    Values m_key{};
};
}  // namespace voxeland
