// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** Dense semantic mapping: one instance for each category, of all opinions that find it the most
 * probable. Overlaps do not matter, so an instance is looked up in the whole map; as there are no
 * more instances than categories, that costs one short pass a frame. What refinement divides would
 * stay divided: use it with `[refinement] split = false`. */
class CCategoryAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CCategoryAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList&) override {}
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap& map) const override;
    /** Never: there is only one instance of a category. */
    [[nodiscard]] bool mayMerge(const InstanceOverlap&, const MergeThresholds&,
                                const SemanticVoxelMap&) const override
    {
        return false;
    }
};
}  // namespace voxeland
