// SPDX-License-Identifier: BSD-3-Clause
#include "JsonValues.h"
#include "voxeland/io/AnswersAsText.h"

namespace voxeland
{
std::string asJson(const SemanticVoxelMap& map, const MapOverview& o)
{
    json_t json = {{"map", mapAsJson(map)},
                   {"box", {{"min", toJson(o.boxMin)}, {"max", toJson(o.boxMax)}}},
                   {"observed_voxels", o.observedVoxels},
                   {"occupied_voxels", o.occupiedVoxels},
                   {"frames", o.counts.frames},
                   {"frames_without_predictions", o.counts.framesWithoutPredictions},
                   {"frames_without_pose", o.counts.framesWithoutPose},
                   {"opinions", o.counts.opinions},
                   {"instances", o.instances},
                   {"categories", json_t::object()},
                   {"memory_bytes", o.memory.bytes},
                   {"bytes_per_free_voxel", o.memory.bytesPerFreeVoxel()},
                   {"bytes_per_surface_voxel", o.memory.bytesPerSurfaceVoxel()}};
    for (const auto& [name, count] : o.categories) json["categories"][name] = count;
    return toText(json);
}

std::string asJson(const SemanticVoxelMap& map, const std::vector<FoundInstance>& instances)
{
    json_t json = json_t::array();
    for (const FoundInstance& f : instances) {
        json.push_back(toJson(map, f.summary, f.box));
        json.back()["distance"] = f.distance;
    }
    return toText(json);
}

std::string asJson(const PlaceAnswer& a)
{
    json_t json = {{"center", toJson(a.center)},
                   {"observed", a.observed},
                   {"occupancy", a.occupancy},
                   {"instances", json_t::array()},
                   {"categories", json_t::object()},
                   {"uncertainty_instances", a.instanceEntropy},
                   {"uncertainty_categories", a.winnerCategoryEntropy},
                   {"uncertainty_semantic", a.categoryEntropy}};
    for (const auto& i : a.instances)
        json["instances"].push_back({{"id", i.id},
                                     {"category", i.category},
                                     {"alpha", i.alpha},
                                     {"probability", i.probability}});
    for (const auto& c : a.categories) json["categories"][c.name] = c.probability;
    return toText(json);
}
}  // namespace voxeland
