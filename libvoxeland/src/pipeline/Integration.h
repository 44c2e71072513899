// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/MapperConfig.h"
#include "voxeland/pipeline/PreparedFrame.h"

#include <vector>

namespace voxeland
{
/** Occupancy by the binary Bayes filter: each voxel the frame saw is updated once, as hit or as
 *  free. Where the pose is uncertain, the log-odds of hit and free are multiplied by the
 * probability that what was seen is in the right voxel, which is computed once for each block. */
void integrateOccupancy(const ObservedSpace& space, SemanticVoxelMap& map,
                        const std::optional<PoseUncertainty>& uncertainty = std::nullopt);

/** Which instance each opinion is about, new instances having been created. */
std::vector<instance_id_t> resolveAssignments(const std::vector<Assignment>& assignments,
                                              SemanticVoxelMap& map);

/** Geometric integration (paper, "Continuous Map Integration"): alpha_k of a voxel grows by the
 * number of 3D points that the opinions about instance k have in it or, with EvidenceRule::novelty,
 * by what these add, as all points that a frame measures in a voxel repeat one another. Where
 * claims exceed a voxel's points, the excess is taken from the least specific ones (confidence over
 * number of voxels; of equals from the later). Points that nobody claims are evidence for
 * *unknown*, but for those in voxels that an instance wins which the detector missed. Where the
 * pose is uncertain, points count by the probability that they are in the right voxel.
 * \param instances that of each opinion, in the same order
 * \param missed instances that are in view though no opinion is about them, in increasing order
 * \param options evidence, and unknown_weight of points for *unknown* */
void integrateGeometry(const PreparedFrame& frame, const std::vector<instance_id_t>& instances,
                       const std::vector<instance_id_t>& missed, const IntegrationOptions& options,
                       SemanticVoxelMap& map);

/** Semantic integration: beta_l of an instance grows by confidence times the opinion's probability
 * of l, raised to IntegrationOptions::sharpness and normalized. The paper adds the confidence to
 * the most probable category alone, which is the limit of a great sharpness: 1 keeps the tails that
 * a network gives to every category, and they hide whether its opinions agree. An uncertain pose
 * takes nothing from it: it says where an object is, not what. \param frameNumber that of the
 * frame, remembered as last seen */
void integrateSemantics(const PreparedFrame& frame, const std::vector<OpinionOverlaps>& opinions,
                        const std::vector<instance_id_t>& instances, uint32_t frameNumber,
                        const IntegrationOptions& options, SemanticVoxelMap& map);

/** Remembers how the frame's image showed the instances, each view under the category its opinion
 * gave most probability to. Opinions that do not say where the image shows them have no view. */
void recordViews(const PreparedFrame& frame, const std::vector<OpinionOverlaps>& opinions,
                 const std::vector<instance_id_t>& instances, uint32_t frameNumber,
                 SemanticVoxelMap& map);
}  // namespace voxeland
