// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/ObservedSpace.h"

#include "voxeland/grid/RayTraversal.h"

#include <array>

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
/** Marks cells in one of the masks; successive ones are mostly of the same block. */
template <CellMask ObservedBlock::*MASK>
class Marker
{
 public:
    explicit Marker(ObservedSpace& space) : m_space(space) {}

    void operator()(const VoxelCoord& v)
    {
        // Any coordinate that differs above its lowest three bits: another block.
        const int32_t change = (v.x ^ m_last.x) | (v.y ^ m_last.y) | (v.z ^ m_last.z);
        if ((change & ~(BLOCK_SIDE - 1)) != 0 || m_mask == nullptr) enter(v);
        m_mask->set(cellOf(v));
    }

 private:
    __attribute__((noinline)) void enter(const VoxelCoord& v)
    {
        // Neighbouring rays go through the same blocks: remember where the last ones were.
        const VoxelCoord block = blockOf(v);
        Visited& visited = m_visited[static_cast<size_t>(cellOf(block))];
        if (visited.mask == nullptr || visited.block != block)
            visited = {block, &(m_space.at(block).*MASK)};
        m_last = v;
        m_mask = visited.mask;
    }

    struct Visited
    {
        VoxelCoord block;
        CellMask* mask = nullptr;
    };

    ObservedSpace& m_space;
    VoxelCoord m_last;  //!< a voxel of the current block
    CellMask* m_mask = nullptr;
    std::array<Visited, BLOCK_CELLS> m_visited;  //!< by the low bits of the block's coordinates
};
}  // namespace

ObservedSpace castRays(const VoxelizedFrame& frame, double visibilityMargin)
{
    ObservedSpace space;
    Marker<&ObservedBlock::passed> markPassed(space);
    Marker<&ObservedBlock::hit> markHit(space);
    Marker<&ObservedBlock::behind> markBehind(space);
    const double inverseResolution = 1 / frame.resolution();
    for (const HitVoxel& h : frame.hits()) {
        traverseRay(frame.origin(), h.centroid, inverseResolution, markPassed);
        markHit(h.coord);
        const TPoint3D direction = h.centroid - frame.origin();
        const TPoint3D end = h.centroid + direction * (visibilityMargin / direction.norm());
        traverseRay(h.centroid, end, inverseResolution, markBehind);
    }
    for (size_t b = 0; b < space.size(); ++b) space[b].passed = space[b].passed - space[b].hit;
    return space;
}
}  // namespace voxeland
