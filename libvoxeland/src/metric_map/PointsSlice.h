// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/maps/CSimplePointsMap.h>

#include <cstdint>
#include <vector>

namespace voxeland
{
/** The points of certain heights, and which of all points they are. */
class PointsSlice
{
 public:
    /** \param lowest, highest heights that belong to it [m] */
    PointsSlice(const mrpt::maps::CSimplePointsMap& all, float lowest, float highest);

    [[nodiscard]] float lowest() const { return m_lowest; }    //!< [m]
    [[nodiscard]] float highest() const { return m_highest; }  //!< [m]
    /** In the order they have among all points [m]. */
    [[nodiscard]] const mrpt::maps::CSimplePointsMap& points() const { return m_points; }
    /** Which of all points a point of points() is. */
    [[nodiscard]] uint32_t indexInAll(size_t i) const { return m_indices[i]; }

 private:
    float m_lowest, m_highest;
    mrpt::maps::CSimplePointsMap m_points;
    std::vector<uint32_t> m_indices;
};
}  // namespace voxeland
