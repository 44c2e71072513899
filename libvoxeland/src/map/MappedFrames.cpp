// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/map/MappedFrames.h"

#include <mrpt/system/datetime.h>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
/** The finalizer of SplitMix64 (Steele, Lea, Flood 2014): every bit of the result depends on every
 * one of the number. */
uint64_t mixed(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
}

/** The same on every machine, as files hold it. */
uint64_t hashOf(const mrpt::Clock::time_point& time, const mrpt::math::TPoint3D& camera)
{
    constexpr double PER_METRE = 1e4, MOST = 9e18;
    auto hash = mixed(static_cast<uint64_t>(time.time_since_epoch().count()));
    for (size_t a = 0; a < 3; ++a) {
        const double place = std::clamp(std::round(camera[a] * PER_METRE), -MOST, MOST);
        hash = mixed(hash + static_cast<uint64_t>(static_cast<int64_t>(place)));
    }
    return hash;
}
}  // namespace

bool MappedFrames::has(const mrpt::Clock::time_point& time,
                       const mrpt::math::TPoint3D& camera) const
{
    return m_hashes.count(hashOf(time, camera)) > 0;
}

bool MappedFrames::add(const mrpt::Clock::time_point& time, const mrpt::math::TPoint3D& camera)
{
    return time == INVALID_TIMESTAMP || m_hashes.insert(hashOf(time, camera)).second;
}

std::vector<uint64_t> MappedFrames::sorted() const
{
    std::vector<uint64_t> hashes(m_hashes.begin(), m_hashes.end());
    std::sort(hashes.begin(), hashes.end());
    return hashes;
}

MappedFrames MappedFrames::restored(const std::vector<uint64_t>& hashes)
{
    MappedFrames frames;
    frames.m_hashes.insert(hashes.begin(), hashes.end());
    return frames;
}
}  // namespace voxeland
