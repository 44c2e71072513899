// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** What systems before Voxeland do: an opinion belongs to the instance of the same most probable
 * category with the greatest intersection over union, if that reaches a fixed threshold. */
class CIoUAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CIoUAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap& map) const override;
    [[nodiscard]] bool mayMerge(const InstanceOverlap& overlap, const MergeThresholds& thresholds,
                                const SemanticVoxelMap& map) const override;

 private:
    double m_tauIoU = 0.25;
    bool m_sameCategory = true;
};
}  // namespace voxeland
