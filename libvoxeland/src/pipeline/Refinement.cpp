// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement.h"

#include "MappingTrace.h"
#include "grid/DensityClustering.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace voxeland
{
namespace
{
using IdPair = std::pair<instance_id_t, instance_id_t>;

/** Voxels an instance wins, with its evidence there as weight. */
std::vector<WeightedCell> wonVoxels(const SemanticVoxelMap& map, instance_id_t id,
                                    const RefinementOptions& options)
{
    std::vector<WeightedCell> won;
    for (const VoxelCoord& b : map.instance(id).blocks) {
        const MapBlock& block = *map.blocks().find(b);
        block.forEachSurface([&](int cell, const VoxelEvidence& evidence) {
            if (map.winner(evidence) == id && OccupancyFilter::isOccupied(block.occupancy(cell)))
                won.push_back({voxelAt(b, cell), 1, static_cast<float>(options.dbscan_min_points)});
        });
    }
    return won;
}

/** The voxels of each cluster, the largest cluster first. */
std::vector<std::vector<VoxelCoord>> partsOf(const std::vector<WeightedCell>& voxels, int radius)
{
    const std::vector<int> clusters = clusterByDensity(voxels, radius);
    std::vector<std::vector<VoxelCoord>> parts;
    for (size_t i = 0; i < voxels.size(); ++i) {
        if (clusters[i] == NOISE) continue;
        const auto c = static_cast<size_t>(clusters[i]);
        if (c >= parts.size()) parts.resize(c + 1);
        parts[c].push_back(voxels[i].coord);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return parts;
}

double evidenceFor(const SemanticVoxelMap& map, instance_id_t id,
                   const std::vector<VoxelCoord>& voxels)
{
    double sum = 0;
    for (const VoxelCoord& v : voxels) sum += static_cast<double>(map.evidence(v)->alphaOf(id));
    return sum;
}

/** Gives every sizeable part but the largest to a new instance. \return how many there were */
uint32_t divide(SemanticVoxelMap& map, instance_id_t id, const RefinementOptions& options,
                uint32_t frame, MappingTrace* trace)
{
    const std::vector<WeightedCell> won = wonVoxels(map, id, options);
    const auto parts = partsOf(won, options.dbscan_eps);
    const size_t sizeable =
        std::max(static_cast<size_t>(options.min_part_voxels),
                 static_cast<size_t>(options.min_part_share * static_cast<double>(won.size())));
    double total = 0;
    for (const auto& part : parts) total += evidenceFor(map, id, part);
    std::vector<instance_id_t> owners = {id};
    for (size_t p = 1; p < parts.size() && parts[p].size() >= sizeable; ++p) {
        const double part = evidenceFor(map, id, parts[p]);
        owners.push_back(map.split(id, parts[p], part / total, frame).id);
        total -= part;
    }
    if (trace != nullptr && parts.size() > 1) trace->division(parts, sizeable, owners);
    return static_cast<uint32_t>(owners.size() - 1);
}

/** Overlaps of the given instances with all others, from one pass over the voxels they share. */
std::vector<InstanceOverlap> overlapsOf(const SemanticVoxelMap& map,
                                        const std::vector<instance_id_t>& ids)
{
    std::set<VoxelCoord> blocks;
    for (const instance_id_t id : ids) {
        const auto& own = map.instance(id).blocks;
        blocks.insert(own.begin(), own.end());
    }
    std::map<IdPair, uint32_t> shared;
    std::vector<instance_id_t> members;
    for (const VoxelCoord& b : blocks)
        map.blocks().find(b)->forEachSurface([&](int, const VoxelEvidence& evidence) {
            members.clear();
            map.forEachMember(evidence, [&](instance_id_t id) { members.push_back(id); });
            for (size_t i = 0; i < members.size(); ++i)
                for (size_t j = i + 1; j < members.size(); ++j) ++shared[{members[i], members[j]}];
        });
    std::vector<InstanceOverlap> overlaps;
    for (const auto& [pair, intersection] : shared) {
        // A pair of two instances that were not seen lately was counted only in part.
        const bool complete = std::binary_search(ids.begin(), ids.end(), pair.first) ||
                              std::binary_search(ids.begin(), ids.end(), pair.second);
        if (!complete) continue;
        const Instance& a = map.instance(pair.first);
        const Instance& b = map.instance(pair.second);
        overlaps.push_back({a.id, b.id, intersection, a.voxels, b.voxels,
                            semanticSimilarity(a.evidence(), b.evidence())});
    }
    std::stable_sort(overlaps.begin(), overlaps.end(),
                     [](const auto& a, const auto& b) { return a.ios() > b.ios(); });
    return overlaps;
}

/** The clusters that hold most of the voxels before `middle` and of those after it. */
std::pair<int, int> mainClusters(const std::vector<WeightedCell>& voxels, std::ptrdiff_t middle,
                                 int radius)
{
    const std::vector<int> clusters = clusterByDensity(voxels, radius);
    return {heaviestCluster({voxels.begin(), voxels.begin() + middle},
                            {clusters.begin(), clusters.begin() + middle}),
            heaviestCluster({voxels.begin() + middle, voxels.end()},
                            {clusters.begin() + middle, clusters.end()})};
}

/** Whether the main parts of two instances are one part once they are put together. */
bool areConnected(const SemanticVoxelMap& map, const InstanceOverlap& overlap,
                  const RefinementOptions& options)
{
    std::vector<WeightedCell> both = wonVoxels(map, overlap.a, options);
    const auto middle = static_cast<std::ptrdiff_t>(both.size());
    const auto ofB = wonVoxels(map, overlap.b, options);
    both.insert(both.end(), ofB.begin(), ofB.end());
    if (middle == 0 || ofB.empty()) return true;  // nothing of one is left to lie apart
    auto [mainOfA, mainOfB] = mainClusters(both, middle, options.dbscan_eps);
    if (mainOfA == NOISE || mainOfB == NOISE) {
        // A scrap too thin to be dense anywhere belongs to what it touches.
        for (WeightedCell& voxel : both) voxel.coreWeight = voxel.weight;
        std::tie(mainOfA, mainOfB) = mainClusters(both, middle, options.dbscan_eps);
    }
    return mainOfA == mainOfB;
}

/** \param merged instances that took part in a merge: their overlaps are measured anew the next
 * time */
MergeDecision decide(const SemanticVoxelMap& map, const InstanceOverlap& overlap,
                     const std::set<instance_id_t>& merged, const CAssociationPolicy& policy,
                     const RefinementOptions& options)
{
    if (merged.count(overlap.a) + merged.count(overlap.b) != 0) return MergeDecision::outdated;
    if (!policy.mayMerge(overlap, options.merge, map)) return MergeDecision::refused;
    if (options.continuity && !areConnected(map, overlap, options)) return MergeDecision::apart;
    return MergeDecision::merged;
}

/** Shows as *unknown* what has too little evidence and was not seen again. Never forgets it.
 *  \param sinceFrame instances that were not seen since keep their state */
void deactivateDoubtful(SemanticVoxelMap& map, const RefinementOptions& options, uint32_t frame,
                        uint32_t sinceFrame)
{
    for (const instance_id_t id : map.seenSince(sinceFrame)) {
        const Instance& instance = map.instance(id);
        const bool doubtful = instance.categories.sum().total() < options.min_evidence;
        if (doubtful && frame > instance.lastFrame + options.patience)
            map.deactivate(id);
        else
            map.reactivate(id);
    }
}
}  // namespace

void refine(SemanticVoxelMap& map, const CAssociationPolicy& policy,
            const RefinementOptions& options, uint32_t sinceFrame, bool isFirst,
            MappingCounts& counts, MappingTrace* trace)
{
    const uint32_t frame = counts.frames > 0 ? counts.frames - 1 : 0;  // the last one mapped
    if (options.split)
        for (const instance_id_t id : map.seenSince(sinceFrame))
            counts.splits += divide(map, id, options, frame, trace);

    std::set<instance_id_t> merged;
    for (const InstanceOverlap& overlap : overlapsOf(map, map.seenSince(sinceFrame))) {
        const MergeDecision decision = decide(map, overlap, merged, policy, options);
        if (trace != nullptr) trace->pair(overlap, decision, options.continuity);
        if (decision != MergeDecision::merged) continue;
        const bool keepA = overlap.voxelsA >= overlap.voxelsB;
        map.merge(keepA ? overlap.a : overlap.b, keepA ? overlap.b : overlap.a, frame);
        merged.insert({overlap.a, overlap.b});
        ++counts.merges;
    }
    // Those seen before were not waited for any longer at the last refinement either.
    const uint32_t waitedFor =
        isFirst || sinceFrame < options.patience ? 0 : sinceFrame - options.patience;
    deactivateDoubtful(map, options, counts.frames, waitedFor);
}
}  // namespace voxeland
