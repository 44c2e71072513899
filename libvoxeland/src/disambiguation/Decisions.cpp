// SPDX-License-Identifier: BSD-3-Clause
#include "Decisions.h"

#include "voxeland/map/MapQueries.h"

#include <algorithm>

namespace voxeland
{
namespace
{
/** Of a decision that says nothing new: every decision is some evidence. */
constexpr double LEAST = 1e-9;

double probabilityOf(const SemanticVoxelMap& map, const Instance& instance, category_id_t category)
{
    for (const RankedCategory& c : categoryDistribution(map, instance))
        if (c.category == category) return c.probability;
    return 0;
}
}  // namespace

void decide(SemanticVoxelMap& map, instance_id_t instance, Decision decision,
            const DisambiguationOptions& options)
{
    Instance& i = map.instance(instance);
    const double known = probabilityOf(map, i, decision.category);
    const double r = options.answer_reliability;
    const double others = options.max_categories;
    const double before = r * known + (1 - r) / (others + 1);
    const double after = before * r / (before * r + (1 - before) * (1 - r) / others);
    // The mean of a Dirichlet with A in all is (known A + e) / (A + e).
    const double all =
        std::max(1.0, map.categoryEvidence(i).total() + map.options().prior_strength);
    const double evidence = all * (after - known) / (1 - after);
    decision.evidence = std::clamp(evidence, LEAST, CategoryEvidence::MOST);
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
