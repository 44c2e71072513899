// SPDX-License-Identifier: BSD-3-Clause
#include "AnswersAsText.h"
#include "exporters/JsonValues.h"

namespace voxeland
{
namespace
{
json_t poseAsJson(const CameraPose& p)
{
    json_t rows = json_t::array();
    const auto matrix = p.pose.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>();
    for (int row = 0; row < 4; ++row)
        rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    return {{"position", toJson(p.pose.translation())},
            {"yaw", p.yaw},
            {"pitch", p.pitch},
            {"distance", p.distance},
            {"visible", p.visible},
            {"matrix", std::move(rows)}};
}
}  // namespace

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
                   {"dismissed", o.inactive},
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

std::string asJson(const std::vector<ReobservationTarget>& targets)
{
    json_t json = json_t::array();
    for (const ReobservationTarget& t : targets) {
        json_t target = {{"kind", t.instance ? "instance" : "region"}};
        if (t.instance) {
            target["id"] = *t.instance;
            target["category"] = t.category;
        }
        target["uncertainty"] = t.uncertainty;
        target["voxels"] = t.voxels;
        target["center"] = toJson(t.center);
        target["poses"] = json_t::array();
        for (const CameraPose& p : t.poses) target["poses"].push_back(poseAsJson(p));
        json.push_back(std::move(target));
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
    if (a.nearest)
        json["nearest"] = {{"id", a.nearest->id},
                           {"category", a.nearest->category},
                           {"distance", a.nearest->distance}};
    return toText(json);
}
}  // namespace voxeland
