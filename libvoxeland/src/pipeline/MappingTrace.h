// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

#include <iosfwd>
#include <vector>

namespace voxeland
{
class MapperConfig;

/** What became of two instances that share voxels. */
enum class MergeDecision
{
    merged,    //!< the one with more voxels (of equals the older) took over the other
    outdated,  //!< one of them changed in a merge just before; measured anew the next time
    refused,   //!< the association policy takes them for two objects
    apart      //!< what is left of them does not touch
};

/** Writes why the map became what it is, as JSON Lines: one object a line.
 *   - First: `thresholds`, the sections [association] and [refinement] in effect.
 *   - An opinion: `frame` (from 0, of those mapped), `opinion` (its number in the frame),
 * `category` (the most probable), `confidence`, `voxels`, `candidates` (each with `instance`,
 * `iou`, `iov`, `iom`, `touched` and `similarity`, see Overlap), `assigned` (to which instance) and
 * `new` (whether that started with this frame).
 *   - A division: `frame`, `divided` (which instance), `least` (size of a part that becomes an
 *     instance [voxels]) and `parts`, largest first, each with `voxels` and `instance` (null: too
 *     small). Instances that are in one part are left out.
 *   - A pair of instances that share voxels: `frame`, `pair`, `voxels` of each, `iou`, `ios`,
 *     `similarity`, `connected` (null: not looked at) and `decision` (see MergeDecision). */
class MappingTrace
{
 public:
    /** Writes the thresholds. \param out must outlive this; what it throws, all functions throw */
    MappingTrace(std::ostream& out, const MapperConfig& config);

    /** The opinions of a frame, which is also the frame of the divisions and pairs that follow.
     *  \param frame its number \param assignments of each opinion \param instances that each
     *  assignment stands for */
    void opinions(uint32_t frame, const std::vector<OpinionOverlaps>& overlaps,
                  const std::vector<Assignment>& assignments,
                  const std::vector<instance_id_t>& instances);

    /** An instance that fell apart. \param parts largest first \param leastVoxels of a part that
     *  becomes an instance \param owners instance of each part, fewer if the last ones are too
     * small
     */
    void division(const std::vector<std::vector<VoxelCoord>>& parts, size_t leastVoxels,
                  const std::vector<instance_id_t>& owners);

    /** Two instances that share voxels. \param continuity whether it was to be verified */
    void pair(const InstanceOverlap& overlap, MergeDecision decision, bool continuity);

 private:
    std::ostream& m_out;
    uint32_t m_frame = 0;
};
}  // namespace voxeland
