// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/metric_map/DistanceField.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
/** The nearest occupied voxel found so far, as seen from a cell. */
struct Candidate
{
    int squared = std::numeric_limits<int>::max() / 2;  //!< [voxels²]
    int8_t x = 0, y = 0, z = 0;

    void improve(int otherSquared, int dx, int dy, int dz)
    {
        if (otherSquared >= squared) return;
        *this = {otherSquared, static_cast<int8_t>(dx), static_cast<int8_t>(dy),
                 static_cast<int8_t>(dz)};
    }
    [[nodiscard]] bool found() const { return squared < std::numeric_limits<int>::max() / 2; }
};
}  // namespace

DistanceField::DistanceField(const SemanticVoxelMap& map, double reach)
    : m_resolution(map.resolution()),
      m_reach(reach),
      // A voxel within reach of a point is within half a voxel more of its cell's centre.
      m_cells(static_cast<int>(std::ceil(m_reach / m_resolution + 0.5))),
      m_lowest(1, 1, 1),
      m_highest(-1, -1, -1)
{
    if (!(reach <= LARGEST_REACH * m_resolution))
        throw std::invalid_argument("a distance of " + std::to_string(reach) +
                                    " m is more than 99 voxels: look less far");
    VoxelCoord lowest{INT32_MAX, INT32_MAX, INT32_MAX}, highest{INT32_MIN, INT32_MIN, INT32_MIN};
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence&) {
        m_occupied.at(blockOf(v)).set(cellOf(v));
        lowest = {std::min(lowest.x, v.x), std::min(lowest.y, v.y), std::min(lowest.z, v.z)};
        highest = {std::max(highest.x, v.x), std::max(highest.y, v.y), std::max(highest.z, v.z)};
    });
    if (m_occupied.size() == 0) return;
    const TPoint3D margin(m_reach, m_reach, m_reach);
    m_lowest = voxelCenter<TPoint3D>(lowest, m_resolution) - margin;
    m_highest = voxelCenter<TPoint3D>(highest, m_resolution) + margin;
}

double DistanceField::squaredDistance(const TPoint3D& p)
{
    const double far = m_reach * m_reach;
    const bool inside = p.x >= m_lowest.x && p.y >= m_lowest.y && p.z >= m_lowest.z &&
                        p.x <= m_highest.x && p.y <= m_highest.y && p.z <= m_highest.z;
    if (!inside) return far;
    const VoxelCoord v = voxelOf(p, 1 / m_resolution);
    const uint32_t block = blockAt(blockOf(v));
    if (block == ALL_FAR) return far;
    const Offset o = m_near[block][static_cast<size_t>(cellOf(v))];
    if (o.x == FAR) return far;
    const auto nearest = voxelCenter<TPoint3D>(v + VoxelCoord{o.x, o.y, o.z}, m_resolution);
    return std::min(far, (nearest - p).sqrNorm());
}

uint32_t DistanceField::blockAt(const VoxelCoord& block)
{
    const uint32_t known = m_index.find(block);
    if (known != CoordHash::NONE) return known;
    const std::vector<VoxelCoord> occupied = occupiedAround(block);
    if (occupied.empty()) return m_index.insert(block, ALL_FAR);
    m_near.push_back(nearestOf(block, occupied));
    return m_index.insert(block, static_cast<uint32_t>(m_near.size() - 1));
}

std::vector<VoxelCoord> DistanceField::occupiedAround(const VoxelCoord& block) const
{
    const int blocks = (m_cells + BLOCK_SIDE - 1) / BLOCK_SIDE;
    std::vector<VoxelCoord> found;
    for (int z = -blocks; z <= blocks; ++z)
        for (int y = -blocks; y <= blocks; ++y)
            for (int x = -blocks; x <= blocks; ++x) {
                const VoxelCoord other = block + VoxelCoord{x, y, z};
                if (const CellMask* cells = m_occupied.find(other))
                    cells->forEach([&](int c) { found.push_back(voxelAt(other, c)); });
            }
    return found;
}

/** The distance transform of a box, one axis after another: the nearest voxel in the cell's row,
 * then in its plane, then in the box (Felzenszwalb and Huttenlocher, "Distance transforms of
 * sampled functions", 2012; rows are short enough here to be searched from end to end). */
DistanceField::Block DistanceField::nearestOf(const VoxelCoord& block,
                                              const std::vector<VoxelCoord>& occupied) const
{
    const int side = BLOCK_SIDE + 2 * m_cells;
    const VoxelCoord corner = voxelAt(block, 0) + VoxelCoord{-m_cells, -m_cells, -m_cells};
    const auto at = [](int z, int y, int rows, int x) {
        return static_cast<size_t>((z * rows + y) * BLOCK_SIDE + x);
    };
    const auto inside = [side](int i) { return i >= 0 && i < side; };

    std::vector<Candidate> inRow(static_cast<size_t>(side * side * BLOCK_SIDE));
    for (const VoxelCoord& v : occupied) {
        const int vx = v.x - corner.x, vy = v.y - corner.y, vz = v.z - corner.z;
        if (!inside(vx) || !inside(vy) || !inside(vz)) continue;
        for (int x = 0; x < BLOCK_SIDE; ++x) {
            const int dx = vx - m_cells - x;
            inRow[at(vz, vy, side, x)].improve(dx * dx, dx, 0, 0);
        }
    }

    std::vector<Candidate> inPlane(static_cast<size_t>(side * BLOCK_SIDE * BLOCK_SIDE));
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < BLOCK_SIDE; ++y)
            for (int dy = -m_cells; dy <= m_cells; ++dy)
                for (int x = 0; x < BLOCK_SIDE; ++x) {
                    const Candidate& c = inRow[at(z, y + m_cells + dy, side, x)];
                    inPlane[at(z, y, BLOCK_SIDE, x)].improve(c.squared + dy * dy, c.x, dy, 0);
                }

    Block result;
    for (int z = 0; z < BLOCK_SIDE; ++z)
        for (int y = 0; y < BLOCK_SIDE; ++y)
            for (int x = 0; x < BLOCK_SIDE; ++x) {
                Candidate best;
                for (int dz = -m_cells; dz <= m_cells; ++dz) {
                    const Candidate& c = inPlane[at(z + m_cells + dz, y, BLOCK_SIDE, x)];
                    best.improve(c.squared + dz * dz, c.x, c.y, dz);
                }
                result[at(z, y, BLOCK_SIDE, x)] =
                    best.found() ? Offset{best.x, best.y, best.z} : Offset{FAR, 0, 0};
            }
    return result;
}
}  // namespace voxeland
