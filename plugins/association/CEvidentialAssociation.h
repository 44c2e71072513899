// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CAssociationPolicy.h"

namespace voxeland
{
/** The paper's association, with its geometric test closed on both sides. An opinion belongs to an
 *  instance if
 *   - their intersection over union reaches tau_iou, or
 *   - it is the visible part of the instance: IoV and IoM (its mirror image, see Overlap) both
 * reach a threshold that goes linearly from tau_iov_strict (S_sem = 0) to tau_iov_relaxed (S_sem =
 * 1), or
 *   - it is a piece of the instance: IoM reaches tau_piece and S_sem piece_similarity.
 *  Among several instances the one with the greatest sum of IoV, IoM and S_sem gets it. Of the
 *  opinions of a frame that lie apart, only the best one gets an instance: detectors seldom see an
 *  object in pieces, but a mask that once covered two objects would tie them together forever.
 *
 *  What is left may go to an instance that no opinion of the frame is about so far, since nothing
 *  else explains why that instance is not seen:
 *   - IoV and IoM need to reach tau_iov_relaxed only, whatever the categories: an object is often
 *     called something else from another side; or
 *   - the instance was seen in a share of tau_piece of the opinion's voxels before, with a S_sem of
 *     piece_similarity, but others outvote it there. Otherwise each sight of a cup on what a table
 *     has claimed would begin another instance, none of which could ever win a voxel.
 */
class CEvidentialAssociation : public CAssociationPolicy
{
    DEFINE_MRPT_OBJECT(CEvidentialAssociation, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    [[nodiscard]] std::vector<Assignment> associate(const std::vector<OpinionOverlaps>& opinions,
                                                    const SemanticVoxelMap& map) const override;
    [[nodiscard]] bool mayMerge(const InstanceOverlap& overlap, const MergeThresholds& thresholds,
                                const SemanticVoxelMap& map) const override;

 private:
    /** Semantic similarity, or what stands for it where it is switched off. */
    [[nodiscard]] double similarity(double measured) const;
    /** Whether the instance may get the opinion. */
    [[nodiscard]] bool isMatch(const Overlap& overlap) const;
    /** The same for an instance that no other opinion of the frame is about. */
    [[nodiscard]] bool isMatchUnclaimed(const Overlap& overlap) const;
    /** Orders the instances an opinion matches: IoV + IoM + S_sem. */
    [[nodiscard]] double quality(const Overlap& overlap) const;

    double m_tauIoU = 0.5, m_tauIoVStrict = 0.6, m_tauIoVRelaxed = 0.25;
    double m_tauPiece = 0.8, m_pieceSimilarity = 0.2;
    bool m_useIoV = true, m_exclusive = true, m_useSimilarity = true, m_unclaimed = true;
};
}  // namespace voxeland
