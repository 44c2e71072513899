// SPDX-License-Identifier: BSD-3-Clause
#include "MappingTrace.h"

#include "voxeland/files/Json.h"
#include "voxeland/pipeline/MapperConfig.h"

#include <algorithm>
#include <ostream>

// Keeps keys in the order they are written here.
using json = nlohmann::ordered_json;

namespace voxeland
{
namespace
{
/** A section with its numbers and truth values as such. */
json sectionOf(const Ini& ini, const std::string& section)
{
    json values = json::object();
    for (const std::string& key : ini.keys(section)) {
        const std::string text = ini.value(section, key);
        const auto value = jsonFrom(text);
        values[key] = value && value->is_primitive() ? json(*value) : json(text);
    }
    return values;
}

json mostProbable(const CategoryDistribution& categories)
{
    const auto top = std::max_element(
        categories.begin(), categories.end(),
        [](const auto& a, const auto& b) { return a.probability < b.probability; });
    return top == categories.end() ? json() : json(top->name);
}

const char* nameOf(MergeDecision decision)
{
    switch (decision) {
        case MergeDecision::merged:
            return "merged";
        case MergeDecision::outdated:
            return "outdated";
        case MergeDecision::refused:
            return "refused";
        default:
            return "apart";
    }
}

void writeLine(std::ostream& out, const json& line)
{
    // Category names come from outside: bytes that are no UTF-8 are replaced.
    out << line.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
}
}  // namespace

MappingTrace::MappingTrace(std::ostream& out, const MapperConfig& config) : m_out(out)
{
    const Ini ini = Ini::fromMap(config.text(), "the configuration in effect");
    json thresholds;
    for (const char* section : {"association", "refinement"})
        thresholds[section] = sectionOf(ini, section);
    writeLine(m_out, {{"thresholds", thresholds}});
}

void MappingTrace::opinions(uint32_t frame, const std::vector<OpinionOverlaps>& overlaps,
                            const std::vector<Assignment>& assignments,
                            const std::vector<instance_id_t>& instances)
{
    m_frame = frame;
    for (size_t i = 0; i < overlaps.size(); ++i) {
        const Opinion& opinion = *overlaps[i].opinion;
        json candidates = json::array();
        for (const Overlap& o : overlaps[i].candidates)
            candidates.push_back({{"instance", o.instance},
                                  {"iou", o.iou()},
                                  {"iov", o.iov()},
                                  {"iom", o.iom()},
                                  {"touched", o.touched()},
                                  {"similarity", o.similarity}});
        writeLine(m_out, {{"frame", frame},
                          {"opinion", i},
                          {"category", mostProbable(opinion.categories)},
                          {"confidence", opinion.confidence},
                          {"voxels", opinion.voxels.size()},
                          {"candidates", candidates},
                          {"assigned", instances[i]},
                          {"new", assignments[i].instance == UNKNOWN_INSTANCE}});
    }
}

void MappingTrace::division(const std::vector<std::vector<VoxelCoord>>& parts, size_t leastVoxels,
                            const std::vector<instance_id_t>& owners)
{
    json list = json::array();
    for (size_t p = 0; p < parts.size(); ++p)
        list.push_back({{"voxels", parts[p].size()},
                        {"instance", p < owners.size() ? json(owners[p]) : json()}});
    writeLine(
        m_out,
        {{"frame", m_frame}, {"divided", owners.front()}, {"least", leastVoxels}, {"parts", list}});
}

void MappingTrace::pair(const InstanceOverlap& overlap, MergeDecision decision, bool continuity)
{
    json connected;
    if (continuity && decision == MergeDecision::merged) connected = true;
    if (decision == MergeDecision::apart) connected = false;
    writeLine(m_out, {{"frame", m_frame},
                      {"pair", json::array({overlap.a, overlap.b})},
                      {"voxels", json::array({overlap.voxelsA, overlap.voxelsB})},
                      {"iou", overlap.iou()},
                      {"ios", overlap.ios()},
                      {"similarity", overlap.similarity},
                      {"connected", connected},
                      {"decision", nameOf(decision)}});
}
}  // namespace voxeland
