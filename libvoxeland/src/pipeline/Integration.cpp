// SPDX-License-Identifier: BSD-3-Clause
#include "Integration.h"

#include "evidence/Displacement.h"
#include "evidence/Repetition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace voxeland
{
namespace
{
/** How much an opinion says about each of its points: a small mask on a large one, a cup on a
 * table, says more about those that both claim. */
float specificity(const Opinion& o)
{
    return o.confidence / static_cast<float>(o.voxels.size());
}

/** The opinions' numbers, those of greatest specificity first. */
std::vector<size_t> mostSpecificFirst(const std::vector<Opinion>& opinions)
{
    std::vector<size_t> order(opinions.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return specificity(opinions[a]) > specificity(opinions[b]);
    });
    return order;
}

/** Middle of an opinion's points [m]. */
mrpt::math::TPoint3D middleOf(const Opinion& opinion, const std::vector<HitVoxel>& hits)
{
    mrpt::math::TPoint3D sum;
    double points = 0;
    for (const OpinionVoxel& v : opinion.voxels) {
        const auto n = static_cast<double>(v.points);
        sum += hits[v.hit].centroid * n;
        points += n;
    }
    return sum * (1 / points);
}

/** Probability that what was seen at a place is in the right voxel. */
double trustIn(const mrpt::math::TPoint3D& place, const PoseUncertainty& uncertainty,
               double resolution)
{
    return probabilityOfStaying(uncertainty.displacement(place), resolution);
}

/** Whether one of some instances, given in increasing order, wins a voxel. */
bool isWonByAny(const std::vector<instance_id_t>& instances, const VoxelCoord& voxel,
                const SemanticVoxelMap& map)
{
    const VoxelEvidence* evidence = instances.empty() ? nullptr : map.evidence(voxel);
    return evidence != nullptr &&
           std::binary_search(instances.begin(), instances.end(), map.winner(*evidence));
}

/** What a point in each hit voxel counts: trustIn() it, 1 where the pose counts as exact; by
 * EvidenceRule::novelty as the points of one voxel repeat one another. */
std::vector<float> weightsOfPoints(const PreparedFrame& frame, EvidenceRule rule)
{
    const std::vector<HitVoxel>& hits = frame.voxels.hits();
    std::vector<float> weights(hits.size(), 1);
    if (frame.uncertainty)
        for (size_t h = 0; h < hits.size(); ++h)
            weights[h] = static_cast<float>(
                trustIn(hits[h].centroid, *frame.uncertainty, frame.voxels.resolution()));
    if (rule == EvidenceRule::novelty)
        for (size_t h = 0; h < hits.size(); ++h)
            weights[h] *= static_cast<float>(weightOfRepetition(hits[h].points));
    return weights;
}

/** The side from which the camera saw an opinion's object. */
side_t sideShown(const PreparedFrame& frame, const Opinion& opinion)
{
    return sideOf(mrpt::math::TPoint3Df(frame.voxels.origin()),
                  mrpt::math::TPoint3Df(middleOf(opinion, frame.voxels.hits())));
}
}  // namespace

void integrateOccupancy(const ObservedSpace& space, SemanticVoxelMap& map,
                        const std::optional<PoseUncertainty>& uncertainty)
{
    const double blockSide = BLOCK_SIDE * map.resolution();
    for (size_t b = 0; b < space.size(); ++b) {
        const ObservedBlock& seen = space[b];
        if (!seen.hit.any() && !seen.passed.any()) continue;
        MapBlock& block = map.blocks().at(space.coordOf(b));
        OccupancyFilter filter = map.occupancyFilter();
        if (uncertainty) {
            const auto middle = voxelCenter<mrpt::math::TPoint3D>(space.coordOf(b), blockSide);
            filter = filter.weakened(trustIn(middle, *uncertainty, map.resolution()));
        }
        seen.hit.forEach(
            [&](int cell) { block.setOccupancy(cell, filter.afterHit(block.occupancy(cell))); });
        seen.passed.forEach(
            [&](int cell) { block.setOccupancy(cell, filter.afterMiss(block.occupancy(cell))); });
    }
}

std::vector<instance_id_t> resolveAssignments(const std::vector<Assignment>& assignments,
                                              SemanticVoxelMap& map)
{
    std::map<uint32_t, instance_id_t> created;
    std::vector<instance_id_t> instances;
    for (const Assignment& a : assignments) {
        instance_id_t id = a.instance;
        if (id == UNKNOWN_INSTANCE) {
            const auto [at, isNew] = created.try_emplace(a.newInstance, UNKNOWN_INSTANCE);
            if (isNew) at->second = map.createInstance().id;
            id = at->second;
        }
        instances.push_back(id);
    }
    return instances;
}

void integrateGeometry(const PreparedFrame& frame, const std::vector<instance_id_t>& instances,
                       const std::vector<instance_id_t>& missed, const IntegrationOptions& options,
                       SemanticVoxelMap& map)
{
    const std::vector<HitVoxel>& hits = frame.voxels.hits();
    const std::vector<float> weights = weightsOfPoints(frame, options.evidence);
    std::vector<float> left;  // points of each voxel that nobody has been given so far
    for (const HitVoxel& hit : hits) left.push_back(static_cast<float>(hit.points));

    for (const size_t i : mostSpecificFirst(frame.opinions))
        for (const OpinionVoxel& v : frame.opinions[i].voxels) {
            const float given = std::min(v.points, left[v.hit]);
            left[v.hit] -= given;
            map.addEvidence(hits[v.hit].coord, instances[i], given * weights[v.hit]);
        }

    const auto unknownWeight = static_cast<float>(options.unknown_weight);
    for (size_t h = 0; h < hits.size(); ++h) {
        const float unknown = left[h] * unknownWeight * weights[h];
        if (unknown > 0 && !isWonByAny(missed, hits[h].coord, map))
            map.addEvidence(hits[h].coord, UNKNOWN_INSTANCE, unknown);
    }
}

void integrateSemantics(const PreparedFrame& frame, const std::vector<OpinionOverlaps>& opinions,
                        const std::vector<instance_id_t>& instances, uint32_t frameNumber,
                        const IntegrationOptions& options, SemanticVoxelMap& map)
{
    for (size_t i = 0; i < opinions.size(); ++i) {
        const Opinion& opinion = *opinions[i].opinion;
        Instance& instance = map.instance(instances[i]);
        CategoryEvidence said;
        said.add(sharpened(opinions[i].categories, options.sharpness),
                 static_cast<double>(opinion.confidence));
        if (options.evidence == EvidenceRule::novelty)
            instance.categories.add(said, sideShown(frame, opinion));
        else
            instance.categories.add(said);
        const bool isNew = instance.observations == 0 && instance.history.empty();
        if (isNew) instance.firstFrame = frameNumber;
        map.saw(instance.id, frameNumber);
        ++instance.observations;
        map.reactivate(instance.id);
        if (opinion.track != InstancePrediction::NO_TRACK) instance.tracks.insert(opinion.track);
    }
}

void recordViews(const PreparedFrame& frame, const std::vector<OpinionOverlaps>& opinions,
                 const std::vector<instance_id_t>& instances, uint32_t frameNumber,
                 SemanticVoxelMap& map)
{
    for (size_t i = 0; i < opinions.size(); ++i) {
        const Opinion& opinion = *opinions[i].opinion;
        const auto category = opinions[i].categories.top();
        if (opinion.region.area == 0 || !category) continue;
        InstanceView view;
        view.frame = frameNumber;
        view.time = frame.time;
        view.box = opinion.region.box;
        view.area = opinion.region.area;
        view.truncated = opinion.region.truncated;
        view.score = opinion.confidence;
        view.probability = static_cast<float>(opinions[i].categories.betaOf(*category));
        view.camera = mrpt::math::TPoint3Df(frame.voxels.origin());
        view.target = mrpt::math::TPoint3Df(middleOf(opinion, frame.voxels.hits()));
        map.instance(instances[i]).views.add(*category, view, map.options().views_kept);
    }
}
}  // namespace voxeland
