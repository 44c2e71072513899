// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Scene.h"

#include <cstdint>
#include <vector>

namespace voxeland::simulation
{
/** A place on the floor [m]. */
struct FloorPoint
{
    float x = 0, y = 0;
};

/** Grid of the floor that tells where a camera can be carried: never through walls and tall
 *  furniture, over low furniture only if there is no other way. */
class WalkableFloor
{
 public:
    explicit WalkableFloor(const Scene& scene);

    /** The free place nearest to p that can be reached from `from`. */
    [[nodiscard]] FloorPoint nearestFree(const FloorPoint& p, const FloorPoint& from) const;
    /** Way of steps of 10 to 15 cm from one free place to another, both ends included.
     *  \throws std::runtime_error if there is none */
    [[nodiscard]] std::vector<FloorPoint> way(const FloorPoint& from, const FloorPoint& to) const;

 private:
    static constexpr float CELL = 0.1F;
    static constexpr float FREE = 1, LOW_FURNITURE = 8, BLOCKED = -1;

    [[nodiscard]] int cellAt(const FloorPoint& p) const;
    [[nodiscard]] FloorPoint centerOf(int cell) const;
    void mark(const Bounds& bounds, float margin, float cost);
    /** For each cell, the one before it on the cheapest way from a cell; -1: unreachable. */
    [[nodiscard]] std::vector<int> cheapestWays(int from) const;

    float m_minX = 0, m_minY = 0;
    int m_columns = 0, m_rows = 0;
    std::vector<float> m_costs;
};
}  // namespace voxeland::simulation
