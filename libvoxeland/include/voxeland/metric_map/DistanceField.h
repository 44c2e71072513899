// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/BlockMap.h"
#include "voxeland/grid/CellMask.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <array>
#include <vector>

namespace voxeland
{
/** How far any point is from the nearest occupied voxel of a map, as the map was when this was
 * made. A block of distances is worked out when one of them is first asked for: what nobody looks
 * at costs nothing. */
class DistanceField
{
 public:
    /** Farthest that can be looked: offsets are kept in bytes [voxels]. */
    static constexpr int LARGEST_REACH = 99;

    /** \param reach what is farther away counts as this far [m]
     *  \throws std::invalid_argument if that is more than LARGEST_REACH */
    DistanceField(const SemanticVoxelMap& map, double reach);

    /** The largest distance given [m]. */
    [[nodiscard]] double reach() const { return m_reach; }

    /** Square of the distance from a point to the centre of the nearest occupied voxel, at most
     *  reach()² [m²]. Nearest is the voxel nearest to the centre of the point's own voxel: exact
     *  for such centres, and elsewhere never too small. Points that are not numbers are far. */
    double squaredDistance(const mrpt::math::TPoint3D& point);

 private:
    /** Where the nearest occupied voxel is, in voxels from a cell; x = FAR if there is none. */
    struct Offset
    {
        int8_t x, y, z;
    };
    static constexpr int8_t FAR = INT8_MAX;
    using Block = std::array<Offset, BLOCK_CELLS>;

    /** Number of the block's distances in m_near, or ALL_FAR. */
    uint32_t blockAt(const VoxelCoord& block);
    /** Occupied voxels of all blocks within m_cells of a block. */
    [[nodiscard]] std::vector<VoxelCoord> occupiedAround(const VoxelCoord& block) const;
    [[nodiscard]] Block nearestOf(const VoxelCoord& block,
                                  const std::vector<VoxelCoord>& occupied) const;

    static constexpr uint32_t ALL_FAR = CoordHash::NONE - 1;

    double m_resolution, m_reach;
    int m_cells;                               //!< how far to look from a cell [voxels]
    mrpt::math::TPoint3D m_lowest, m_highest;  //!< nothing outside this box is near
    BlockMap<CellMask> m_occupied;
    CoordHash m_index;
    std::vector<Block> m_near;
};
}  // namespace voxeland
