// SPDX-License-Identifier: BSD-3-Clause
#include "InstancesJson.h"

#include "JsonValues.h"
#include "voxeland/base/printable.h"
#include "voxeland/files/AtomicFile.h"

#include <algorithm>
#include <sstream>

namespace voxeland
{
namespace
{
/** Evidence by category name, the strongest first. */
json_t evidenceAsJson(const SemanticVoxelMap& map, const Instance& instance)
{
    auto entries = map.categoryEvidence(instance).entries();
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.beta > b.beta; });
    json_t::object_t object;  // names are unique: they need not be looked for
    for (const auto& e : entries) object.emplace_back(map.categories().name(e.category), e.beta);
    return object;
}
}  // namespace

json_t toJson(const mrpt::math::TPoint3D& p)
{
    return {p.x, p.y, p.z};
}

json_t toJson(const SemanticVoxelMap& map, const InstanceSummary& summary, const OrientedBox& box)
{
    json_t json;
    json["bbox"] = {{"center", toJson((summary.boxMin + summary.boxMax) * 0.5)},
                    {"size", toJson(summary.boxMax - summary.boxMin)}};
    json["results"] = evidenceAsJson(map, map.instance(summary.id));
    json["n_observations"] = summary.observations;
    json["id"] = summary.id;
    json["category"] = summary.category();
    json["probability"] = summary.probability();
    json_t::object_t probabilities;
    for (const auto& c : summary.categories) probabilities.emplace_back(c.name, c.probability);
    json["probabilities"] = std::move(probabilities);
    json["entropy"] = summary.entropy;
    json["vacuity"] = summary.vacuity;
    json["geometric_entropy"] = summary.geometricEntropy;
    json["voxels"] = summary.voxels;
    json["centroid"] = toJson(summary.centroid);
    json["oriented_box"] = {{"center", toJson(box.center)},
                            {"size", toJson(box.size)},
                            {"yaw", box.yaw},
                            {"axes", json_t::array()}};
    for (const auto& axis : box.axes.axes()) json["oriented_box"]["axes"].push_back(toJson(axis));
    return json;
}

json_t mapAsJson(const SemanticVoxelMap& map)
{
    return {{"resolution", map.resolution()},
            {"frame", "world of the poses the map was built with, metres"},
            {"entropy_measure", toString(map.options().entropy)},
            {"prior_strength", map.options().prior_strength},
            {"categories", map.categories().names()}};
}

std::string toText(const json_t& json)
{
    std::istringstream lines(json.dump(2, ' ', false, json_t::error_handler_t::replace));
    std::string text;
    // What JSON does not escape, but terminals act upon, is escaped as JSON allows, too.
    for (std::string line; std::getline(lines, line);) text += printable(line, UNCUT) + "\n";
    return text;
}

std::string instancesAsJson(const SemanticVoxelMap& map, const GravityAlignedFrame& frame)
{
    const auto boxes = orientedBoxes(map, frame);
    json_t json;
    json["map"] = mapAsJson(map);
    json["instances"] = json_t::object();
    for (const InstanceSummary& s : summarizeInstances(map))
        json["instances"]["obj" + std::to_string(s.id)] = toJson(map, s, boxes.at(s.id));
    return toText(json);
}

void exportJson(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                const std::string& file)
{
    writeAtomically(file, instancesAsJson(map, frame));
}

Exporter jsonExporter()
{
    Exporter e{"json", "FILE", "Instances with evidence, probabilities, entropies and boxes"};
    e.endings = {".json"};
    e.nameInAll = "instances.json";
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportJson(map, settings.frame, file);
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
