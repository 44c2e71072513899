// SPDX-License-Identifier: BSD-3-Clause
#include "WalkableFloor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>

namespace voxeland::simulation
{
WalkableFloor::WalkableFloor(const Scene& scene)
{
    constexpr float TALL = 1.15F, HEAD = 1.9F, STEP = 0.05F;  // heights [m]
    constexpr float BODY = 0.28F, LEGS = 0.15F;               // distances to keep [m]
    float maxX = 0, maxY = 0;
    for (const auto& room : scene.rooms()) {
        maxX = std::max(maxX, room.maxX);
        maxY = std::max(maxY, room.maxY);
    }
    m_columns = static_cast<int>(std::ceil((maxX - m_minX) / CELL));
    m_rows = static_cast<int>(std::ceil((maxY - m_minY) / CELL));
    m_costs.assign(static_cast<size_t>(m_columns) * static_cast<size_t>(m_rows), FREE);
    for (const auto& part : scene.parts()) {
        const Bounds& b = part.solid.bounds();
        if (b.max.z < STEP || b.min.z > HEAD) continue;
        const bool low = b.max.z < TALL;
        mark(b, low ? LEGS : BODY, low ? LOW_FURNITURE : BLOCKED);
    }
}

void WalkableFloor::mark(const Bounds& b, float margin, float cost)
{
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column) {
            const int cell = row * m_columns + column;
            const FloorPoint p = centerOf(cell);
            if (p.x < b.min.x - margin || p.x > b.max.x + margin || p.y < b.min.y - margin ||
                p.y > b.max.y + margin)
                continue;
            float& old = m_costs[static_cast<size_t>(cell)];
            if (old != BLOCKED) old = cost;
        }
}

int WalkableFloor::cellAt(const FloorPoint& p) const
{
    const int column = static_cast<int>(std::floor((p.x - m_minX) / CELL)),
              row = static_cast<int>(std::floor((p.y - m_minY) / CELL));
    return std::clamp(row, 0, m_rows - 1) * m_columns + std::clamp(column, 0, m_columns - 1);
}

FloorPoint WalkableFloor::centerOf(int cell) const
{
    return {m_minX + (static_cast<float>(cell % m_columns) + 0.5F) * CELL,
            m_minY + (static_cast<float>(cell / m_columns) + 0.5F) * CELL};
}

FloorPoint WalkableFloor::nearestFree(const FloorPoint& p, const FloorPoint& from) const
{
    const auto reached = cheapestWays(cellAt(from));
    float best = std::numeric_limits<float>::max();
    FloorPoint nearest = from;
    for (int cell = 0; cell < m_columns * m_rows; ++cell) {
        const auto i = static_cast<size_t>(cell);
        if (m_costs[i] != FREE || reached[i] < 0) continue;
        const FloorPoint c = centerOf(cell);
        const float distance = std::hypot(c.x - p.x, c.y - p.y);
        if (distance < best) {
            best = distance;
            nearest = c;
        }
    }
    return nearest;
}

std::vector<FloorPoint> WalkableFloor::way(const FloorPoint& from, const FloorPoint& to) const
{
    const int start = cellAt(from);
    const auto previous = cheapestWays(start);
    std::vector<FloorPoint> result;
    for (int cell = cellAt(to);; cell = previous[static_cast<size_t>(cell)]) {
        if (previous[static_cast<size_t>(cell)] < 0)
            throw std::runtime_error("the simulated camera finds no way between two rooms");
        result.push_back(centerOf(cell));
        if (cell == start) break;
    }
    std::reverse(result.begin(), result.end());
    return result;
}

std::vector<int> WalkableFloor::cheapestWays(int from) const
{
    std::vector<int> previous(m_costs.size(), -1);
    std::vector<float> cost(m_costs.size(), std::numeric_limits<float>::max());
    using Entry = std::pair<float, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(0.0F, from);
    cost[static_cast<size_t>(from)] = 0;
    previous[static_cast<size_t>(from)] = from;
    while (!open.empty()) {
        const auto [soFar, cell] = open.top();
        open.pop();
        if (soFar > cost[static_cast<size_t>(cell)]) continue;
        const int column = cell % m_columns, row = cell / m_columns;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int c = column + dx, r = row + dy;
                if (c < 0 || r < 0 || c >= m_columns || r >= m_rows) continue;
                const int next = r * m_columns + c;
                const auto i = static_cast<size_t>(next);
                if (m_costs[i] == BLOCKED) continue;
                const float step = dx != 0 && dy != 0 ? std::sqrt(2.0F) : 1.0F;
                const float total = soFar + step * m_costs[i];
                if (total >= cost[i]) continue;
                cost[i] = total;
                previous[i] = cell;
                open.emplace(total, next);
            }
    }
    return previous;
}
}  // namespace voxeland::simulation
