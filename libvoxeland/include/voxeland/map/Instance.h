// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/grid/VoxelCoord.h"
#include "voxeland/map/CategoryEvidence.h"
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
    CategoryEvidence categories;  //!< beta of the Dirichlet over categories, as detectors said
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

    /** beta of the Dirichlet over categories, decisions included. */
    [[nodiscard]] CategoryEvidence evidence() const
    {
        CategoryEvidence all = categories;
        for (const Decision& d : decisions) all.add(d.category, d.evidence);
        return all;
    }
};
}  // namespace voxeland
