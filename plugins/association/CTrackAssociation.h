// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** Believes the detector: an opinion belongs to the instance that has its track id. For trackers,
 * and with true identities as the best that any association could do. Opinions without a track
 * become instances of their own.
 * Cost: an object is nearly always found among those it overlaps; only a frame that brings a track
 * which is not there passes once over all instances of the map. */
class CTrackAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CTrackAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList&) override {}
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap& map) const override;
    /** Never: identities are the detector's business. */
    [[nodiscard]] bool mayMerge(const InstanceOverlap&, const MergeThresholds&,
                                const SemanticVoxelMap&) const override
    {
        return false;
    }
};
}  // namespace voxeland
