// SPDX-License-Identifier: BSD-3-Clause
#include "UncertainInstance.h"

#include <algorithm>

namespace voxeland
{
namespace
{
/** Whether an instance is worth a question, whatever its size. */
bool isUndecided(const InstanceSummary& summary, const Instance& instance,
                 const DisambiguationOptions& options)
{
    return summary.entropy > options.entropy_threshold &&
           (options.ask_again || instance.decisions.empty());
}

/** The likeliest categories that a detector named. */
std::vector<RankedCategory> candidatesOf(const InstanceSummary& summary, const Instance& instance,
                                         size_t most)
{
    std::vector<RankedCategory> candidates;
    for (const RankedCategory& c : summary.categories)
        if (candidates.size() < most && instance.categories.sum().betaOf(c.category) > 0)
            candidates.push_back(c);
    return candidates;
}
}  // namespace

std::vector<UncertainInstance> uncertainInstances(const SemanticVoxelMap& map,
                                                  const DisambiguationOptions& options)
{
    std::vector<UncertainInstance> uncertain;
    for (const InstanceSummary& summary : summarizeInstances(map)) {
        const Instance& instance = map.instance(summary.id);
        if (summary.voxels < options.min_voxels || !isUndecided(summary, instance, options))
            continue;
        UncertainInstance u;
        u.id = summary.id;
        u.entropy = summary.entropy;
        u.candidates = candidatesOf(summary, instance, options.max_categories);
        for (const RankedCategory& c : u.candidates)
            for (const InstanceView& view : instance.views.of(c.category))
                u.views.push_back({c.category, view, {}, {}, 0});
        if (!u.views.empty()) uncertain.push_back(std::move(u));
    }
    std::stable_sort(uncertain.begin(), uncertain.end(),
                     [](const auto& a, const auto& b) { return a.entropy > b.entropy; });
    if (options.max_questions > 0 && uncertain.size() > options.max_questions)
        uncertain.resize(options.max_questions);
    return uncertain;
}

size_t countTooSmallToAsk(const SemanticVoxelMap& map, const DisambiguationOptions& options)
{
    const auto all = summarizeInstances(map);
    const auto count = std::count_if(all.begin(), all.end(), [&](const InstanceSummary& summary) {
        return summary.voxels < options.min_voxels &&
               isUndecided(summary, map.instance(summary.id), options);
    });
    return static_cast<size_t>(count);
}
}  // namespace voxeland
