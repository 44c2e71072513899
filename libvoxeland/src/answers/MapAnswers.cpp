// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/answers/MapAnswers.h"

#include "voxeland/level/UpDirection.h"
#include "voxeland/map/CategorySearch.h"

#include <algorithm>
#include <limits>

namespace voxeland
{
namespace
{
std::vector<FoundInstance> allInstances(const SemanticVoxelMap& map,
                                        const GravityAlignedFrame& frame)
{
    const auto boxes = orientedBoxes(map, frame);
    std::vector<FoundInstance> all;
    for (InstanceSummary& s : summarizeInstances(map)) {
        const OrientedBox& box = boxes.at(s.id);
        all.push_back({std::move(s), box});
    }
    return all;
}

/** Name of the most probable category of an instance. */
std::string categoryOf(const SemanticVoxelMap& map, instance_id_t id)
{
    if (id == UNKNOWN_INSTANCE) return UNKNOWN_CATEGORY;
    const auto ranked = categoryDistribution(map, map.instance(id));
    return ranked.empty() ? UNKNOWN_CATEGORY : ranked.front().name;
}

/** Whether any object has evidence in a voxel; null: one without evidence. */
bool isOfObject(const VoxelEvidence* evidence)
{
    return evidence != nullptr &&
           std::any_of(evidence->begin(), evidence->end(),
                       [](const auto& e) { return e.instance != UNKNOWN_INSTANCE; });
}

std::optional<PlaceAnswer::NearestObject> nearestObject(const SemanticVoxelMap& map,
                                                        const mrpt::math::TPoint3D& place)
{
    std::optional<PlaceAnswer::NearestObject> nearest;
    for (const auto& [id, voxels] : voxelsByWinner(map)) {
        if (id == UNKNOWN_INSTANCE) continue;
        for (const VoxelCoord& v : voxels) {
            const double distance =
                (voxelCenter<mrpt::math::TPoint3D>(v, map.resolution()) - place).norm();
            if (!nearest || distance < nearest->distance) nearest = {id, "", distance};
        }
    }
    if (nearest) nearest->category = categoryOf(map, nearest->id);
    return nearest;
}
}  // namespace

MapOverview overviewOf(const SemanticVoxelMap& map, const MappingCounts& counts)
{
    MapOverview overview;
    overview.counts = counts;
    overview.resolution = map.resolution();
    overview.memory = map.memory();
    overview.observedVoxels = overview.memory.observedVoxels;
    constexpr double INF = std::numeric_limits<double>::infinity();
    mrpt::math::TPoint3D low(INF, INF, INF), high(-INF, -INF, -INF);
    map.forEachVoxel([&](const VoxelCoord& v, const auto&...) {
        const auto p = voxelCenter<mrpt::math::TPoint3D>(v, map.resolution());
        for (size_t a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], p[a] - map.resolution() / 2);
            high[a] = std::max(high[a], p[a] + map.resolution() / 2);
        }
        ++overview.occupiedVoxels;
    });
    if (overview.occupiedVoxels > 0) {
        overview.boxMin = map.inWorld(low);
        overview.boxMax = map.inWorld(high);
    }
    overview.inactive = map.inactive().size();
    for (const InstanceSummary& s : summarizeInstances(map)) {
        ++overview.instances;
        ++overview.categories[s.category()];
    }
    return overview;
}

std::vector<FoundInstance> listInstances(const SemanticVoxelMap& map)
{
    return listInstances(map, GravityAlignedFrame(estimateUp(map)));
}

std::vector<FoundInstance> listInstances(const SemanticVoxelMap& map,
                                         const GravityAlignedFrame& frame)
{
    auto all = allInstances(map, frame);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        const uint32_t va = a.summary.voxels, vb = b.summary.voxels;
        return va != vb ? va > vb : a.summary.probability() > b.summary.probability();
    });
    return all;
}

std::vector<FoundInstance> findInstances(const SemanticVoxelMap& map, const std::string& category,
                                         const mrpt::math::TPoint3D& from)
{
    static_cast<void>(map.voxelOf(map.inMap(from)));  // in range
    std::vector<FoundInstance> found;
    NameFit best = NameFit::part;
    for (FoundInstance& f : allInstances(map, GravityAlignedFrame(estimateUp(map)))) {
        const NameFit fit = nameFit(category, f.summary.category());
        if (fit < best) continue;
        if (fit > best) found.clear();
        best = fit;
        f.distance = (f.summary.centroid - from).norm();
        found.push_back(std::move(f));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    return found;
}

PlaceAnswer askPlace(const SemanticVoxelMap& map, const mrpt::math::TPoint3D& placeInWorld)
{
    PlaceAnswer answer;
    const mrpt::math::TPoint3D place = map.inMap(placeInWorld);
    const VoxelCoord v = map.voxelOf(place);
    answer.center = map.inWorld(voxelCenter<mrpt::math::TPoint3D>(v, map.resolution()));
    answer.observed = map.occupancy(v) != UNOBSERVED;
    answer.occupancy = OccupancyFilter::probability(map.occupancy(v));
    const VoxelEvidence* evidence = map.evidence(v);
    if (!isOfObject(evidence)) answer.nearest = nearestObject(map, place);
    if (evidence == nullptr) return answer;

    const auto total = static_cast<double>(evidence->total());
    for (const auto& e : *evidence) {
        const std::string name = categoryOf(map, e.instance);
        const auto alpha = static_cast<double>(e.alpha);
        answer.instances.push_back({e.instance, name, alpha, alpha / total});
    }
    std::stable_sort(answer.instances.begin(), answer.instances.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });

    VoxelUncertainty uncertainty(map);
    const std::vector<double>& p = uncertainty.categories(*evidence);
    for (category_id_t c = 0; c < p.size(); ++c)
        if (p[c] > 0)
            answer.categories.push_back(
                {c, c < map.categories().size() ? map.categories().name(c) : UNKNOWN_CATEGORY,
                 p[c]});
    std::stable_sort(answer.categories.begin(), answer.categories.end(),
                     [](const auto& a, const auto& b) { return a.probability > b.probability; });
    answer.instanceEntropy = uncertainty.instanceEntropy(*evidence);
    answer.winnerCategoryEntropy = uncertainty.winnerCategoryEntropy(*evidence);
    answer.categoryEntropy = uncertainty.categoryEntropy(*evidence);
    return answer;
}
}  // namespace voxeland
