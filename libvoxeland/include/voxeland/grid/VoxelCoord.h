// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
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

/** Whether a metric point (any type with x, y, z, maybe no numbers) lies in a voxel that can be
 * stored. \param inverseResolution 1/edge [1/m] */
template <typename Point>
bool isInRange(const Point& p, double inverseResolution)
{
    const auto fits = [inverseResolution](double metres) {
        return std::abs(std::floor(metres * inverseResolution)) <= MAX_VOXEL_COORD;
    };
    return fits(p.x) && fits(p.y) && fits(p.z);
}

/** Bits of each axis in packed(). */
inline constexpr int PACKED_BITS = 21;

/** One number per coordinate, 21 bits an axis; injective within +-MAX_VOXEL_COORD. */
constexpr uint64_t packed(const VoxelCoord& c)
{
    constexpr uint64_t MASK = (1u << PACKED_BITS) - 1;
    return (static_cast<uint64_t>(c.x) & MASK) |
           ((static_cast<uint64_t>(c.y) & MASK) << PACKED_BITS) |
           ((static_cast<uint64_t>(c.z) & MASK) << (2 * PACKED_BITS));
}

/** Inverse of packed(). */
constexpr VoxelCoord unpacked(uint64_t key)
{
    constexpr uint64_t MASK = (1u << PACKED_BITS) - 1;
    constexpr int32_t SIGN = 1 << (PACKED_BITS - 1);
    const auto axis = [key](int a) {
        return (static_cast<int32_t>((key >> (a * PACKED_BITS)) & MASK) ^ SIGN) - SIGN;
    };
    return {axis(0), axis(1), axis(2)};
}

/** The lowest BITS bits of packed coordinates side by side, x lowest.
 *  To multiply by a sum of powers of two is to add shifted copies of the key. One multiplication
 *  moves all three: of each copy one axis lands in its place, and what lands elsewhere is cut. */
template <int BITS>
constexpr size_t lowBits(uint64_t key)
{
    static_assert(3 * BITS <= PACKED_BITS, "the copies would overlap");
    constexpr int X = 2 * PACKED_BITS;  // where x goes; y and z go next to it
    constexpr uint64_t AXIS = (1u << BITS) - 1;
    constexpr uint64_t ALL = AXIS | (AXIS << PACKED_BITS) | (AXIS << (2 * PACKED_BITS));
    constexpr uint64_t MOVES =
        (uint64_t{1} << X) | (uint64_t{1} << (PACKED_BITS + BITS)) | (uint64_t{1} << (2 * BITS));
    return (((key & ALL) * MOVES) >> X) & ((1u << (3 * BITS)) - 1);
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

/** Whether a block holds voxels that can be stored. */
inline bool isInRange(const VoxelCoord& block)
{
    const auto fits = [](int32_t i) {
        return i >= (-MAX_VOXEL_COORD >> 3) && i <= (MAX_VOXEL_COORD >> 3);
    };
    return fits(block.x) && fits(block.y) && fits(block.z);
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

/** The voxel that holds a metric point, whatever its numbers: none if it cannot be stored, or if
 *  they are no numbers. For points that do not come from a frame. */
template <typename Point>
std::optional<VoxelCoord> storableVoxelOf(const Point& p, double inverseResolution)
{
    if (!isInRange(p, inverseResolution)) return std::nullopt;
    return voxelOf(p, inverseResolution);
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
