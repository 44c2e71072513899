// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** The paper's association: an opinion belongs to an instance if their intersection over union
 * reaches tau_IoU, or the intersection over what is visible of the instance reaches tau_IoV, which
 * goes linearly from strict (S_sem = 0) to relaxed (S_sem = 1). Among several the best one gets it.
 */
class CEvidentialAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CEvidentialAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap& map) const override;
    [[nodiscard]] bool mayMerge(const InstanceOverlap& overlap,
                                const SemanticVoxelMap& map) const override;

 private:
    /** How well an opinion matches an instance; negative: not at all. */
    [[nodiscard]] double matchQuality(const Overlap& overlap) const;

    double m_tauIoU = 0.3, m_tauIoVStrict = 0.7, m_tauIoVRelaxed = 0.35;
    double m_mergeIoU = 0.8, m_mergeIoS = 0.6, m_mergeSimilarity = 0.7;
};
}  // namespace voxeland
