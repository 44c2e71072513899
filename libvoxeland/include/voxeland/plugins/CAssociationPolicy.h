// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/SemanticVoxelMap.h"
#include "voxeland/plugins/Overlap.h"
#include "voxeland/plugins/Plugin.h"

#include <vector>

namespace voxeland
{
inline namespace VOXELAND_PLUGIN_ABI
{
/** What a policy decided about one opinion. */
struct Assignment
{
    /** The map instance it belongs to, or UNKNOWN_INSTANCE for a new one. */
    instance_id_t instance = UNKNOWN_INSTANCE;
    /** Which new instance of this frame: opinions with the same number start one together. Only
     * used where `instance` is UNKNOWN_INSTANCE. */
    uint32_t newInstance = 0;
};

/** Base of the plugins that decide which map instance an opinion is about (paper, "Data
 * Association"), and which map instances are one object. Chosen in section [association] of the
 * INI. */
class CAssociationPolicy : public Plugin
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CAssociationPolicy)

 public:
    /** Decides for all opinions of a frame.
     *  \param opinions each with its overlaps with the map's instances
     *  \return one decision per opinion, in the same order */
    [[nodiscard]] virtual std::vector<Assignment> associate(
        const std::vector<OpinionOverlaps>& opinions, const SemanticVoxelMap& map) const = 0;

    /** Whether two map instances that share voxels are one object, as far as overlap and categories
     * say. Asked during refinement; continuity is verified afterwards. */
    [[nodiscard]] virtual bool mayMerge(const InstanceOverlap& overlap,
                                        const MergeThresholds& thresholds,
                                        const SemanticVoxelMap& map) const = 0;
};
}  // namespace VOXELAND_PLUGIN_ABI
}  // namespace voxeland
