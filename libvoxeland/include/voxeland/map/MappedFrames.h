// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/core/Clock.h>
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace voxeland
{
/** Which frames a map was made from, so that none is evidence twice. Memory: one number a frame. */
class MappedFrames
{
 public:
    /** \param time of the frame; frames of an invalid time are never known
     *  \param camera optical centre [m], in any frame of reference that stays the same; places
     * within 0.1 mm are one */
    [[nodiscard]] bool has(const mrpt::Clock::time_point& time,
                           const mrpt::math::TPoint3D& camera) const;
    /** \return whether the frame was not known */
    bool add(const mrpt::Clock::time_point& time, const mrpt::math::TPoint3D& camera);

    /** \name For files: a hash of each frame's time and camera
     * @{ */
    [[nodiscard]] std::vector<uint64_t> sorted() const;
    static MappedFrames restored(const std::vector<uint64_t>& hashes);
    /** @} */

 private:
    std::unordered_set<uint64_t> m_hashes;
};
}  // namespace voxeland
