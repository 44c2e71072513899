// SPDX-License-Identifier: BSD-3-Clause
#include "Reobservation.h"

#include "voxeland/map/MapQueries.h"
#include "voxeland/observations/RgbdFrame.h"

#include <algorithm>

namespace voxeland
{
namespace
{
constexpr size_t LEAST_OF_INSTANCE = 5, LEAST_OF_REGION = 20;  //!< voxels

/** A target with the voxels to look at. */
struct Candidate
{
    ReobservationTarget target;
    std::vector<VoxelCoord> voxels;
};

/** Voxels that belong together, with what is said of them. */
struct Group
{
    std::vector<VoxelCoord> voxels;
    double entropies = 0;  //!< sum of H(I_v) [nat]
};

Candidate candidateOf(const SemanticVoxelMap& map, std::vector<VoxelCoord> voxels,
                      double uncertainty)
{
    Candidate candidate;
    candidate.target.uncertainty = uncertainty;
    candidate.target.voxels = voxels.size();
    for (const VoxelCoord& v : voxels)
        candidate.target.center += voxelCenter<mrpt::math::TPoint3D>(v, map.resolution()) *
                                   (1 / static_cast<double>(voxels.size()));
    candidate.voxels = std::move(voxels);
    return candidate;
}

std::vector<Candidate> allCandidates(const SemanticVoxelMap& map)
{
    std::map<instance_id_t, std::vector<VoxelCoord>> instances;
    std::map<VoxelCoord, Group> regions;
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        const instance_id_t winner = map.winner(evidence);
        if (winner != UNKNOWN_INSTANCE) instances[winner].push_back(v);
        if (winner == UNKNOWN_INSTANCE && evidence.size() <= 1) return;
        Group& region = regions[blockOf(v)];
        region.voxels.push_back(v);
        region.entropies += instanceEntropy(map, evidence);
    });
    std::vector<Candidate> all;
    for (auto& [id, voxels] : instances) {
        if (voxels.size() < LEAST_OF_INSTANCE) continue;
        const Instance& instance = map.instance(id);
        const auto ranked = categoryDistribution(map, instance);
        all.push_back(candidateOf(map, std::move(voxels), categoryEntropy(map, instance)));
        all.back().target.instance = id;
        all.back().target.category = ranked.empty() ? UNKNOWN_CATEGORY : ranked.front().name;
    }
    for (auto& [block, region] : regions) {
        if (region.voxels.size() < LEAST_OF_REGION) continue;
        const double mean = region.entropies / static_cast<double>(region.voxels.size());
        all.push_back(candidateOf(map, std::move(region.voxels), mean));
    }
    return all;
}
}  // namespace

std::vector<ReobservationTarget> planReobservation(const SemanticVoxelMap& map,
                                                   const GravityAlignedFrame& frame,
                                                   const CarriedCamera& camera, size_t most)
{
    std::vector<Candidate> all = allCandidates(map);
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return a.target.uncertainty > b.target.uncertainty;
    });
    all.resize(std::min(most, all.size()));
    const double floor = floorHeight(map, frame);
    std::vector<ReobservationTarget> targets;
    for (Candidate& c : all) {
        c.target.poses = placeCamera(map, frame, camera, floor, c.voxels);
        c.target.center = map.inWorld(c.target.center);
        for (CameraPose& p : c.target.poses) p.pose = relativeTo(-map.origin(), p.pose);
        targets.push_back(std::move(c.target));
    }
    return targets;
}
}  // namespace voxeland
