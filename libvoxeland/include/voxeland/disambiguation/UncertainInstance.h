// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/MapQueries.h"
#include "voxeland/pipeline/DisambiguationOptions.h"

#include <string>
#include <vector>

namespace voxeland
{
/** A view to be shown in a question. */
struct ChosenView
{
    category_id_t category = 0;  //!< what a detector took it for
    InstanceView view;
    std::string picture;     //!< the object, as JPEG; empty until it was fetched
    std::string wholeFrame;  //!< where it is, as JPEG; empty unless wanted
};

/** An instance to ask about. */
struct UncertainInstance
{
    instance_id_t id = UNKNOWN_INSTANCE;
    double entropy = 0;                      //!< [nat]
    std::vector<RankedCategory> candidates;  //!< the likeliest first
    std::vector<ChosenView> views;           //!< in the order of the candidates
};

/** Chooses the instances to ask about, the most uncertain first, with candidates (the likeliest
 * categories that have evidence) and views. Instances that no image shows are left out. */
std::vector<UncertainInstance> uncertainInstances(const SemanticVoxelMap& map,
                                                  const DisambiguationOptions& options);
}  // namespace voxeland
