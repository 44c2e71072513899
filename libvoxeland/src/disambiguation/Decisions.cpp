// SPDX-License-Identifier: BSD-3-Clause
#include "Decisions.h"

#include <algorithm>

namespace voxeland
{
void decide(SemanticVoxelMap& map, instance_id_t instance, Decision decision,
            const DisambiguationOptions& options)
{
    Instance& i = map.instance(instance);
    const double all = i.evidence().total() + map.options().prior_strength;
    decision.evidence = std::min(options.decision_weight * all, CategoryEvidence::MOST);
    i.decisions.push_back(std::move(decision));
}

size_t undoDecisions(SemanticVoxelMap& map, std::optional<instance_id_t> instance)
{
    std::vector<instance_id_t> ids;
    if (instance)
        ids = {map.resolve(*instance)};
    else
        for (const auto& [id, i] : map.instances()) ids.push_back(id);
    size_t undone = 0;
    for (const instance_id_t id : ids) {
        if (id == UNKNOWN_INSTANCE) continue;
        auto& decisions = map.instance(id).decisions;
        undone += decisions.size();
        decisions.clear();
    }
    return undone;
}
}  // namespace voxeland
