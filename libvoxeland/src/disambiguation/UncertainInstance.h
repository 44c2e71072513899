// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/MapQueries.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <string>
#include <vector>

namespace voxeland
{
/** A view that a question may show. */
struct CandidateView
{
    category_id_t category = 0;  //!< what a detector took it for
    InstanceView view;
    std::string picture;     //!< the object, as JPEG; empty until it was fetched
    std::string wholeFrame;  //!< where it is, as JPEG; empty unless wanted
    float sharpness = 0;     //!< of the picture, see sharpnessOf(); 0 until it was fetched
};

/** An instance to ask about. */
struct UncertainInstance
{
    instance_id_t id = UNKNOWN_INSTANCE;
    double entropy = 0;                      //!< [nat]
    std::vector<RankedCategory> candidates;  //!< the likeliest first
    std::vector<CandidateView> views;        //!< in the order of the candidates
};

/** Chooses the instances to ask about, the most uncertain first, with candidates (the likeliest
 * categories that have evidence) and all views the map remembers of them. Instances that no image
 * shows are left out. */
std::vector<UncertainInstance> uncertainInstances(const SemanticVoxelMap& map,
                                                  const DisambiguationOptions& options);

/** How many instances are as uncertain but of fewer than DisambiguationOptions::min_voxels voxels.
 */
size_t countTooSmallToAsk(const SemanticVoxelMap& map, const DisambiguationOptions& options);
}  // namespace voxeland
