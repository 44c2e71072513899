// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/pipeline/InstanceCounter.h"
#include "voxeland/pipeline/PreparedFrame.h"
#include "voxeland/plugins/Overlap.h"

#include <vector>

namespace voxeland
{
class SemanticVoxelMap;

/** Measures how a frame's opinions overlap with a map's instances (paper, "Data Association").
 * Cost: the surface voxels the frame sees, whatever the size of the map. */
class OverlapFinder
{
 public:
    /** One entry per opinion, in the same order; the frame must outlive them. New category names
     * are added to the map's table.
     * \param sharpness exponent of category probabilities before they count as evidence: semantic
     * similarity compares the opinion with the instance as evidence of both */
    std::vector<OpinionOverlaps> find(const PreparedFrame& frame, double sharpness,
                                      SemanticVoxelMap& map);

    /** Instances that the detector most likely missed: after find(), those of which the frame shows
     * more than a share of the voxels though none of its opinions is about them. Cost: the
     * instances in view. \param claimed the instances that its opinions are about \param share in
     * [0,1]; 1: none was \return in increasing order */
    [[nodiscard]] std::vector<instance_id_t> missed(const std::vector<instance_id_t>& claimed,
                                                    double share, const SemanticVoxelMap& map);

 private:
    void countVisible(const ObservedSpace& space, const SemanticVoxelMap& map);

    InstanceCounter m_visible, m_common, m_touched;
};
}  // namespace voxeland
