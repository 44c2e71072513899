// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/ObservedSpace.h"

#include "grid/RayPacket.h"
#include "voxeland/observations/UnusableFrame.h"

#include <algorithm>
#include <array>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
[[noreturn]] void throwTooMany()
{
    throw UnusableFrame(
        "it sees more voxels than fit into memory: use a coarser [map] resolution or a smaller "
        "[voxeland] max_depth");
}

/** Finds blocks by the keys of their voxels: packed() coordinates relative to a center, each with
 *  its sign flipped: counted from the lowest there is, so that steps do not carry over between axes
 *  near the center. */
class BlockFinder
{
 public:
    BlockFinder(const VoxelCoord& center, ObservedSpace& space)
        : m_space(space), m_base(voxelAt(blockOf(center), 0)), m_slots(size_t{1} << (3 * SLOT_BITS))
    {
    }

    [[nodiscard]] uint64_t keyOf(const VoxelCoord& v) const
    {
        return packed({v.x - m_base.x, v.y - m_base.y, v.z - m_base.z}) ^ SIGNS;
    }
    static int cellOf(uint64_t key) { return static_cast<int>(lowBits<3>(key)); }

    ObservedBlock& at(uint64_t key)
    {
        // To look up every cell's block is faster than to remember the block until the ray leaves
        // it, which processors cannot predict.
        Slot& slot = m_slots[lowBits<SLOT_BITS>(key >> 3)];
        if (slot.block != (key & ~CELL)) fill(slot, key);
        return *slot.observed;
    }

 private:
    static constexpr int SLOT_BITS = 4;  //!< of each axis: blocks in a cube of 2^4 never collide
    static constexpr uint64_t CELL = packed({7, 7, 7});
    static constexpr int32_t SIGN = 1 << (PACKED_BITS - 1);
    static constexpr uint64_t SIGNS = packed({SIGN, SIGN, SIGN});

    struct Slot
    {
        uint64_t block = CELL;  //!< key without the bits of CELL; initially that of no block
        ObservedBlock* observed = nullptr;
    };

    __attribute__((noinline)) void fill(Slot& slot, uint64_t key)
    {
        slot = {key & ~CELL, &m_space.at(blockOf(m_base + unpacked(key ^ SIGNS)))};
        if (m_space.size() > RayLimits::BLOCKS) throwTooMany();
    }

    ObservedSpace& m_space;
    VoxelCoord m_base;
    std::vector<Slot> m_slots;
};

int32_t stepsBetween(const VoxelCoord& a, const VoxelCoord& b)
{
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

/** Casts rays and marks the cells they go through, RayPacket::RAYS at a time. */
class RayCaster
{
 public:
    RayCaster(const VoxelizedFrame& frame, double margin, ObservedSpace& space)
        : m_origin(frame.origin()),
          m_start(voxelOf(m_origin, 1 / frame.resolution())),
          m_inverseResolution(1 / frame.resolution()),
          m_margin(margin),
          m_blocks(m_start, space)
    {
    }

    /** Casts a ray to each voxel's point. \param AIM how: aimAt or aimThrough */
    template <int32_t (RayCaster::*AIM)(size_t, const TPoint3D&)>
    void cast(const std::vector<HitVoxel>& voxels)
    {
        for (size_t i = 0; i < voxels.size(); i += RayPacket::RAYS) {
            const size_t rays = std::min(RayPacket::RAYS, voxels.size() - i);
            int32_t longest = 0;
            for (size_t r = 0; r < rays; ++r)
                longest = std::max(longest, (this->*AIM)(r, voxels[i + r].centroid));
            walk(rays, longest);
        }
    }

    /** Aims at a measured point. \return steps to the end of the ray, behind the point */
    int32_t aimAt(size_t ray, const TPoint3D& point)
    {
        const TPoint3D direction = point - m_origin;
        const TPoint3D end = point + direction * (m_margin / direction.norm());
        m_toEnd[ray] = set(ray, end);
        m_toHit[ray] = stepsBetween(m_start, voxelOf(point, m_inverseResolution));
        return m_toEnd[ray];
    }

    /** Aims through a point: what was measured lies behind it. \return steps to before its voxel */
    int32_t aimThrough(size_t ray, const TPoint3D& point)
    {
        m_toHit[ray] = set(ray, point) - 1;
        m_toEnd[ray] = m_toHit[ray] - 1;  // nothing is behind a surface
        return m_toHit[ray];
    }

 private:
    static constexpr int32_t STEPS = 16;

    /** \return steps to the end */
    int32_t set(size_t ray, const TPoint3D& end)
    {
        const GridRay way(m_origin, end, m_inverseResolution);
        m_rays.set(ray, way, m_blocks.keyOf(m_start));
        return way.steps;
    }

    void walk(size_t rays, int32_t longest)
    {
        for (m_done = 0; m_done <= longest; m_done += STEPS) {
            m_rays.walk(STEPS, m_keys.data());
            for (size_t r = 0; r < rays; ++r) {
                mark<&ObservedBlock::passed>(r, 0, m_toHit[r]);
                mark<&ObservedBlock::behind>(r, m_toHit[r], m_toEnd[r]);
            }
        }
    }

    /** Marks a ray's cells from the first to the last, as far as they are among m_keys. */
    template <CellMask ObservedBlock::*MASK>
    void mark(size_t ray, int32_t first, int32_t last)
    {
        const int32_t end = std::min(last + 1 - m_done, STEPS);
        for (int32_t s = std::max(first - m_done, 0); s < end; ++s) {
            const uint64_t key = m_keys[static_cast<size_t>(s) * RayPacket::RAYS + ray];
            (m_blocks.at(key).*MASK).set(BlockFinder::cellOf(key));
        }
    }

    TPoint3D m_origin;
    VoxelCoord m_start;
    double m_inverseResolution, m_margin;
    BlockFinder m_blocks;
    RayPacket m_rays;
    std::array<int32_t, RayPacket::RAYS> m_toHit{}, m_toEnd{};  //!< steps from m_start
    int32_t m_done = 0;                                         //!< steps before those of m_keys
    std::array<uint64_t, STEPS * RayPacket::RAYS> m_keys{};
};
}  // namespace

namespace
{
/** \throws UnusableFrame if a frame is beyond RayLimits::CELLS or the range of a map */
void checkExtent(const VoxelizedFrame& frame)
{
    const VoxelCoord camera = voxelOf(frame.origin(), 1 / frame.resolution());
    uint64_t cells = 0;
    for (const auto* voxels : {&frame.hits(), &frame.beyond()})
        for (const HitVoxel& h : *voxels) {
            if (!isInRange(blockOf(h.coord)))
                throw UnusableFrame("it lies farther off than the map can hold: map it on its own");
            cells += static_cast<uint64_t>(stepsBetween(camera, h.coord));
        }
    if (cells > RayLimits::CELLS) throwTooMany();
}
}  // namespace

ObservedSpace castRays(const VoxelizedFrame& frame, double visibilityMargin)
{
    checkExtent(frame);
    ObservedSpace space;
    for (const HitVoxel& h : frame.hits()) space.at(blockOf(h.coord)).hit.set(cellOf(h.coord));
    RayCaster caster(frame, visibilityMargin, space);
    caster.cast<&RayCaster::aimAt>(frame.hits());
    caster.cast<&RayCaster::aimThrough>(frame.beyond());
    for (size_t b = 0; b < space.size(); ++b) space[b].passed = space[b].passed - space[b].hit;
    return space;
}
}  // namespace voxeland
