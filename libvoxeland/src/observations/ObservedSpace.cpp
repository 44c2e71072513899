// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/observations/ObservedSpace.h"

#include "voxeland/grid/RayTraversal.h"

using mrpt::math::TPoint3D;

namespace voxeland
{
namespace
{
/** Marks cells; successive ones are mostly of the same block. */
class Marker
{
 public:
    explicit Marker(ObservedSpace& space) : m_space(space) {}

    void mark(const VoxelCoord& v, CellMask ObservedBlock::*mask)
    {
        const VoxelCoord block = blockOf(v);
        if (m_current == nullptr || block != m_block) {
            m_block = block;
            m_current = &m_space.at(block);
        }
        (m_current->*mask).set(cellOf(v));
    }

 private:
    ObservedSpace& m_space;
    VoxelCoord m_block;
    ObservedBlock* m_current = nullptr;
};
}  // namespace

ObservedSpace castRays(const VoxelizedFrame& frame, double visibilityMargin)
{
    ObservedSpace space;
    Marker marker(space);
    const double inverseResolution = 1 / frame.resolution();
    for (const HitVoxel& h : frame.hits()) {
        traverseRay(frame.origin(), h.centroid, inverseResolution,
                    [&](const VoxelCoord& v) { marker.mark(v, &ObservedBlock::passed); });
        marker.mark(h.coord, &ObservedBlock::hit);
        const TPoint3D direction = h.centroid - frame.origin();
        const TPoint3D end = h.centroid + direction * (visibilityMargin / direction.norm());
        traverseRay(h.centroid, end, inverseResolution,
                    [&](const VoxelCoord& v) { marker.mark(v, &ObservedBlock::behind); });
    }
    for (size_t b = 0; b < space.size(); ++b) space[b].passed = space[b].passed - space[b].hit;
    return space;
}
}  // namespace voxeland
