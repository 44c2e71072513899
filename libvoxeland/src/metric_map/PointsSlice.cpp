// SPDX-License-Identifier: BSD-3-Clause
#include "PointsSlice.h"

namespace voxeland
{
PointsSlice::PointsSlice(const mrpt::maps::CSimplePointsMap& all, float lowest, float highest)
    : m_lowest(lowest), m_highest(highest)
{
    const auto &x = all.getPointsBufferRef_x(), &y = all.getPointsBufferRef_y(),
               &z = all.getPointsBufferRef_z();
    for (size_t i = 0; i < z.size(); ++i) {
        if (z[i] < lowest || z[i] > highest) continue;
        m_points.insertPoint(x[i], y[i], z[i]);
        m_indices.push_back(static_cast<uint32_t>(i));
    }
}
}  // namespace voxeland
