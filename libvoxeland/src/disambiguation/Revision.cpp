// SPDX-License-Identifier: BSD-3-Clause
#include "Revision.h"

#include "Decisions.h"

#include <algorithm>

namespace voxeland
{
Revision::Revision(const SemanticVoxelMap& input, std::string source) : m_source(std::move(source))
{
    for (const auto& [id, instance] : input.instances())
        m_decisions[id] = instance.decisions.size();
}

std::vector<Decision>::iterator Revision::firstSince(Instance& instance) const
{
    const auto had = m_decisions.find(instance.id);
    const size_t count = had == m_decisions.end() ? 0 : had->second;
    return instance.decisions.begin() +
           static_cast<std::ptrdiff_t>(std::min(count, instance.decisions.size()));
}

size_t Revision::withdraw(Instance& instance) const
{
    auto& decisions = instance.decisions;
    const auto kept = std::remove_if(firstSince(instance), decisions.end(),
                                     [&](const Decision& d) { return d.source == m_source; });
    const auto withdrawn = static_cast<size_t>(decisions.end() - kept);
    decisions.erase(kept, decisions.end());
    return withdrawn;
}

size_t Revision::withdraw(SemanticVoxelMap& map) const
{
    std::vector<instance_id_t> ids;
    for (const auto& [id, instance] : map.instances()) ids.push_back(id);
    size_t withdrawn = 0;
    for (const instance_id_t id : ids) withdrawn += withdraw(map.instance(id));
    return withdrawn;
}

void Revision::decide(SemanticVoxelMap& map, instance_id_t instance, const Decision& decision,
                      const DisambiguationOptions& options) const
{
    Instance& decided = map.instance(instance);
    const bool isSaid =
        std::any_of(firstSince(decided), decided.decisions.end(), [&](const Decision& d) {
            return d.source == m_source && d.category == decision.category &&
                   d.answer == decision.answer;
        });
    if (isSaid) return;
    withdraw(decided);
    voxeland::decide(map, instance, decision, options);
}
}  // namespace voxeland
