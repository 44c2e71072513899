// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <tuple>

namespace voxeland
{
/** Integer coordinates of a voxel: voxel (i,j,k) covers [i,i+1) x [j,j+1) x [k,k+1) edges.
 *  Usable range: +-2^20 voxels around the origin on each axis (52 km at 5 cm). */
struct VoxelCoord
{
    int32_t x = 0, y = 0, z = 0;

    friend bool operator==(const VoxelCoord& a, const VoxelCoord& b)
    {
        return a.x == b.x && a.y == b.y && a.z == b.z;
    }
    friend bool operator!=(const VoxelCoord& a, const VoxelCoord& b) { return !(a == b); }
    /** Order by z, then y, then x: that of the cells inside a block. */
    friend bool operator<(const VoxelCoord& a, const VoxelCoord& b)
    {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    }
    friend VoxelCoord operator+(const VoxelCoord& a, const VoxelCoord& b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
};

/** Largest absolute voxel coordinate that can be stored. */
inline constexpr int32_t MAX_VOXEL_COORD = (1 << 20) - 1;

/** Bits of each axis in packed(). */
inline constexpr int PACKED_BITS = 21;

/** One number per coordinate, 21 bits an axis; injective within +-MAX_VOXEL_COORD. */
inline uint64_t packed(const VoxelCoord& c)
{
    constexpr uint64_t MASK = (1u << PACKED_BITS) - 1;
    return (static_cast<uint64_t>(c.x) & MASK) |
           ((static_cast<uint64_t>(c.y) & MASK) << PACKED_BITS) |
           ((static_cast<uint64_t>(c.z) & MASK) << (2 * PACKED_BITS));
}

/** Blocks of 8x8x8 voxels: the unit of storage. A block's coordinates are those of its voxels
 *  divided by 8, rounded down. */
inline constexpr int BLOCK_SIDE = 8;
inline constexpr int BLOCK_CELLS = BLOCK_SIDE * BLOCK_SIDE * BLOCK_SIDE;

/** The block that holds a voxel (an arithmetic shift: right for negative coordinates). */
inline VoxelCoord blockOf(const VoxelCoord& v)
{
    return {v.x >> 3, v.y >> 3, v.z >> 3};
}

/** Position of a voxel inside its block, 0..511, x fastest. */
inline int cellOf(const VoxelCoord& v)
{
    return (v.x & 7) | ((v.y & 7) << 3) | ((v.z & 7) << 6);
}

/** Inverse of blockOf() and cellOf(). */
inline VoxelCoord voxelAt(const VoxelCoord& block, int cell)
{
    return {block.x * BLOCK_SIDE + (cell & 7), block.y * BLOCK_SIDE + ((cell >> 3) & 7),
            block.z * BLOCK_SIDE + (cell >> 6)};
}

/** Voxel index of one metric coordinate. \param inverseResolution 1/edge [1/m] */
inline int32_t voxelIndex(double metres, double inverseResolution)
{
    return static_cast<int32_t>(std::floor(metres * inverseResolution));
}

/** The voxel that holds a metric point (any type with x, y, z). */
template <typename Point>
VoxelCoord voxelOf(const Point& p, double inverseResolution)
{
    return {voxelIndex(p.x, inverseResolution), voxelIndex(p.y, inverseResolution),
            voxelIndex(p.z, inverseResolution)};
}

/** Metric centre of a voxel. \param resolution edge [m] */
template <typename Point>
Point voxelCenter(const VoxelCoord& v, double resolution)
{
    using T = decltype(Point::x);
    return Point(static_cast<T>((v.x + 0.5) * resolution), static_cast<T>((v.y + 0.5) * resolution),
                 static_cast<T>((v.z + 0.5) * resolution));
}
}  // namespace voxeland
