// SPDX-License-Identifier: BSD-3-Clause
#include "FloorPlan.h"

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
/** Floor covered by a group whose frame stands at (x,y), turned by quarter turns. */
Room footprint(const FurnitureGroup& g, float x, float y, int quarterTurns)
{
    const float near = g.atWall ? 0 : -g.depth / 2, far = g.atWall ? g.depth : g.depth / 2;
    const float side = g.width / 2;
    switch (quarterTurns) {
        case 0:
            return {x + near, y - side, x + far, y + side};
        case 1:
            return {x - side, y + near, x + side, y + far};
        case 2:
            return {x - far, y - side, x - near, y + side};
        default:
            return {x - side, y - far, x + side, y - near};
    }
}
}  // namespace

std::optional<mrpt::poses::CPose3D> FloorPlan::place(const FurnitureGroup& group, Random& random)
{
    constexpr int ATTEMPTS = 300;
    for (int i = 0; i < ATTEMPTS; ++i) {
        const int turns = random.below(4);
        float x = random.uniform(m_room.minX, m_room.maxX),
              y = random.uniform(m_room.minY, m_room.maxY);
        if (group.atWall && turns == 0) x = m_room.minX;
        if (group.atWall && turns == 1) y = m_room.minY;
        if (group.atWall && turns == 2) x = m_room.maxX;
        if (group.atWall && turns == 3) y = m_room.maxY;
        const Room rectangle = footprint(group, x, y, turns);
        if (!isFree(rectangle)) continue;
        reserve(rectangle);
        return mrpt::poses::CPose3D(x, y, 0, turns * M_PI / 2, 0, 0);
    }
    return std::nullopt;
}

bool FloorPlan::isFree(const Room& r) const
{
    if (r.minX < m_room.minX || r.minY < m_room.minY || r.maxX > m_room.maxX ||
        r.maxY > m_room.maxY)
        return false;
    return std::none_of(m_taken.begin(), m_taken.end(), [&](const Room& t) {
        return r.minX < t.maxX && t.minX < r.maxX && r.minY < t.maxY && t.minY < r.maxY;
    });
}
}  // namespace voxeland::simulation
