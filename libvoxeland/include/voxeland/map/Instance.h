// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"
#include "voxeland/map/CategoryOpinions.h"
#include "voxeland/map/Decision.h"
#include "voxeland/map/InstanceEvent.h"
#include "voxeland/map/InstanceViews.h"
#include "voxeland/map/VoxelEvidence.h"

#include <cstdint>
#include <set>
#include <vector>

namespace voxeland
{
/** What a map knows of one object, besides the evidence in its voxels. */
struct Instance
{
    instance_id_t id = UNKNOWN_INSTANCE;
    CategoryOpinions categories;  //!< what detectors said it is
    uint32_t voxels = 0;          //!< number of voxels that are part of it (MapOptions::membership)
    uint32_t observations = 0;    //!< number of opinions integrated
    uint32_t firstFrame = 0;      //!< number of the frame that first saw it, from 0
    uint32_t lastFrame =
        0;  //!< number of the frame that last saw it; set by SemanticVoxelMap::saw()
    std::set<int64_t> tracks;            //!< the detector's track ids, where it gives any
    std::set<VoxelCoord> blocks;         //!< blocks where it has, or once had, evidence
    InstanceViews views;                 //!< where it was seen best
    std::vector<InstanceEvent> history;  //!< its last merges and splits, in order of time
    std::vector<Decision> decisions;     //!< what was decided about it offline, in order of time

    /** Opinions by what they add, in the detector's words, and decisions. What that means is told
     * by SemanticVoxelMap::categoryEvidence(). */
    [[nodiscard]] CategoryEvidence evidence() const
    {
        return withDecisions(categories.independent());
    }
    /** Evidence, and decisions on top. */
    [[nodiscard]] CategoryEvidence withDecisions(CategoryEvidence evidence) const
    {
        for (const Decision& d : decisions) evidence.add(d.category, d.evidence);
        return evidence;
    }
};
}  // namespace voxeland
