// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/Comparison.h"

#include "PointMatching.h"
#include "voxeland/map/MapQueries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace voxeland
{
namespace
{
constexpr uint32_t NONE = std::numeric_limits<uint32_t>::max();

/** What one annotated point says. */
struct PointRecord
{
    uint32_t object = NONE, instance = NONE;  //!< positions in the scene
    float entropy = 0, probability = 0;
};

double scoreOf(const SemanticVoxelMap& map, const InstanceSummary& s, ScoreKind kind)
{
    const auto categories = static_cast<double>(std::max<size_t>(2, map.categories().size()));
    switch (kind) {
        case ScoreKind::certainty:
            return std::max(0.0, 1 - s.entropy / std::log(categories));
        case ScoreKind::observations:
            return s.observations;
        default:
            return s.probability();
    }
}

/** Appends the map's instances. \return position of each id */
std::unordered_map<instance_id_t, uint32_t> addInstances(const SemanticVoxelMap& map,
                                                         const LabelMap& labels, ScoreKind score,
                                                         EvaluatedScene& scene)
{
    std::unordered_map<instance_id_t, uint32_t> positions;
    for (const InstanceSummary& s : summarizeInstances(map)) {
        positions[s.id] = static_cast<uint32_t>(scene.instances.size());
        PredictedInstance p;
        p.id = s.id;
        p.category = s.category();
        p.cls = labels.classOf(p.category);
        p.score = scoreOf(map, s, score);
        p.probability = s.probability();
        p.entropy = s.entropy;
        scene.instances.push_back(p);
    }
    return positions;
}

/** Appends the annotated objects, ordered by id. \return position of each id */
std::unordered_map<uint32_t, uint32_t> addObjects(const GroundTruth& truth, const LabelMap& labels,
                                                  EvaluatedScene& scene)
{
    std::map<uint32_t, std::map<uint32_t, size_t>> pointsOf;  // object -> category -> points
    for (size_t i = 0; i < truth.points.size(); ++i)
        if (truth.instance[i] != 0) ++pointsOf[truth.instance[i]][truth.category[i]];
    std::unordered_map<uint32_t, uint32_t> positions;
    for (const auto& [id, categories] : pointsOf) {
        TrueObject o;
        o.id = id;
        const auto most =
            std::max_element(categories.begin(), categories.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        o.category = truth.names.at(most->first);
        o.cls = labels.classOf(o.category);
        for (const auto& [category, points] : categories) o.points += points;
        positions[id] = static_cast<uint32_t>(scene.objects.size());
        scene.objects.push_back(o);
    }
    return positions;
}

void addOverlaps(const std::vector<PointRecord>& records, EvaluatedScene& scene)
{
    std::map<std::pair<uint32_t, uint32_t>, size_t> shared;
    for (const PointRecord& r : records) {
        if (r.instance == NONE) continue;
        ++scene.instances[r.instance].points;
        if (r.object != NONE) ++shared[{r.object, r.instance}];
    }
    for (const auto& [pair, points] : shared)
        scene.overlaps.push_back({pair.first, pair.second, points});
}

void addPointDecisions(const std::vector<PointRecord>& records, VoidPolicy policy,
                       EvaluatedScene& scene)
{
    std::vector<SharedPoints> largest(scene.instances.size(), {NONE, 0, 0});
    for (const SharedPoints& o : scene.overlaps)
        if (o.points > largest[o.instance].points) largest[o.instance] = o;
    for (const PointRecord& r : records) {
        if (r.instance == NONE || (r.object == NONE && policy == VoidPolicy::ignore)) continue;
        const bool right = r.object != NONE && largest[r.instance].object == r.object;
        scene.pointDecisions.push_back(
            {static_cast<double>(r.entropy), !right, static_cast<double>(r.probability)});
    }
}
}  // namespace

EvaluatedScene compare(const SemanticVoxelMap& map, const GroundTruth& truth,
                       const LabelMap& labels, const EvaluationProtocol& protocol,
                       const std::string& name)
{
    EvaluatedScene scene;
    scene.name = name;
    const auto instances = addInstances(map, labels, protocol.score, scene);
    const auto objects = addObjects(truth, labels, scene);

    const PointMatching matching(map, matchRadius(protocol, map.resolution()));
    std::vector<PointRecord> records(truth.points.size());
    for (size_t i = 0; i < records.size(); ++i) {
        PointRecord& r = records[i];
        if (truth.instance[i] != 0) r.object = objects.at(truth.instance[i]);
        const VoxelEvidence* evidence = matching.find(truth.points[i]);
        const instance_id_t winner = evidence == nullptr ? UNKNOWN_INSTANCE : map.winner(*evidence);
        if (winner == UNKNOWN_INSTANCE) continue;
        r.instance = instances.at(winner);
        r.entropy = static_cast<float>(instanceEntropy(map, *evidence));
        r.probability = static_cast<float>(winnerProbability(map, *evidence));
    }
    addOverlaps(records, scene);
    addPointDecisions(records, protocol.voidPolicy, scene);
    return scene;
}
}  // namespace voxeland
