// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceExplanation.h"

#include "base/ClassicNumbers.h"
#include "base/timeText.h"
#include "exporters/JsonValues.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/printable.h"

#include <mrpt/core/format.h>

#include <algorithm>

namespace voxeland
{
namespace
{
/** Evidence that an instance's decisions gave a category. */
double decidedFor(const Instance& instance, category_id_t category)
{
    double sum = 0;
    for (const Decision& d : instance.decisions)
        if (d.category == category) sum += d.evidence;
    return sum;
}

/** The distribution without categories that only the prior speaks for. */
std::vector<RankedCategory> spokenFor(const SemanticVoxelMap& map, const Instance& instance)
{
    auto ranked = categoryDistribution(map, instance);
    const CategoryEvidence evidence = map.categoryEvidence(instance);
    ranked.erase(
        std::remove_if(ranked.begin(), ranked.end(),
                       [&](const RankedCategory& c) { return !(evidence.betaOf(c.category) > 0); }),
        ranked.end());
    return ranked;
}

std::string categoriesAsText(const SemanticVoxelMap& map, const Instance& instance)
{
    std::string text = "categories      p      detectors  decisions\n";
    for (const RankedCategory& c : spokenFor(map, instance)) {
        text +=
            format("  %-12s  %.3f  %9.3f  %9.3f\n", printable(c.name).c_str(), c.probability,
                   instance.categories.sum().betaOf(c.category), decidedFor(instance, c.category));
        for (const InstanceView& v : instance.views.of(c.category))
            text += format("      frame %-6u p %.2f, score %.2f, %dx%d pixels at %d,%d, %.1f m%s\n",
                           v.frame, static_cast<double>(v.probability),
                           static_cast<double>(v.score), v.box.width, v.box.height, v.box.x,
                           v.box.y, static_cast<double>((v.target - v.camera).norm()),
                           v.truncated ? ", cut off" : "");
    }
    return text;
}

std::string decisionsAsText(const SemanticVoxelMap& map, const Instance& instance)
{
    constexpr size_t LONGEST_ANSWER = 400;
    std::string text;
    for (const Decision& d : instance.decisions)
        text += format(
            "decision        %s: evidence %.3f, by %s (%s), %.1f s, %s\n"
            "                \"%s\"\n",
            printable(map.categories().name(d.category)).c_str(), d.evidence,
            printable(d.source).c_str(), printable(d.model).c_str(), d.seconds,
            counted(d.promptTokens + d.answerTokens, "token").c_str(),
            printable(d.answer, LONGEST_ANSWER).c_str());
    return text;
}

json_t toJson(const SemanticVoxelMap& map, const InstanceView& v)
{
    using mrpt::math::TPoint3D;
    return {{"frame", v.frame},
            {"timestamp", mrpt::Clock::toDouble(v.time)},
            {"probability", v.probability},
            {"score", v.score},
            {"box", {v.box.x, v.box.y, v.box.width, v.box.height}},
            {"area", v.area},
            {"truncated", v.truncated},
            {"camera", voxeland::toJson(map.inWorld(TPoint3D(v.camera)))},
            {"target", voxeland::toJson(map.inWorld(TPoint3D(v.target)))}};
}

json_t toJson(const SemanticVoxelMap& map, const Decision& d)
{
    return {{"category", map.categories().name(d.category)},
            {"evidence", d.evidence},
            {"source", d.source},
            {"model", d.model},
            {"answer", d.answer},
            {"time", timeText(d.time)},
            {"questions", d.questions},
            {"seconds", d.seconds},
            {"prompt_tokens", d.promptTokens},
            {"answer_tokens", d.answerTokens},
            {"cost", d.cost}};
}

const char* nameOf(InstanceEvent::Kind kind)
{
    return kind == InstanceEvent::Kind::merged ? "merged" : "divided";
}
}  // namespace

std::string explanationAsText(const SemanticVoxelMap& map, instance_id_t id)
{
    const Instance& i = map.instance(id);
    const auto ranked = categoryDistribution(map, i);
    std::string text = format(
        "instance        %u, %s\n"
        "entropy         %.3f nat (%s), vacuity %.3f\n"
        "seen            %s, frames %u to %u, part of %s\n",
        id, printable(ranked.empty() ? UNKNOWN_CATEGORY : ranked.front().name).c_str(),
        categoryEntropy(map, i), toString(map.options().entropy).c_str(), categoryVacuity(map, i),
        counted(i.observations, "time").c_str(), i.firstFrame, i.lastFrame,
        counted(i.voxels, "voxel").c_str());
    text += categoriesAsText(map, i);
    for (const InstanceEvent& e : i.history)
        text += e.kind == InstanceEvent::Kind::merged
                    ? format("frame %-9u %u took over %u\n", e.frame, e.instance, e.other)
                    : format("frame %-9u %u was separated from %u\n", e.frame, e.other, e.instance);
    return text + decisionsAsText(map, i);
}

std::string explanationAsJson(const SemanticVoxelMap& map, instance_id_t id)
{
    const Instance& i = map.instance(id);
    const auto ranked = categoryDistribution(map, i);
    json_t json = {{"id", id},
                   {"category", ranked.empty() ? UNKNOWN_CATEGORY : ranked.front().name},
                   {"probability", ranked.empty() ? 0 : ranked.front().probability},
                   {"entropy", categoryEntropy(map, i)},
                   {"vacuity", categoryVacuity(map, i)},
                   {"voxels", i.voxels},
                   {"observations", i.observations},
                   {"first_frame", i.firstFrame},
                   {"last_frame", i.lastFrame}};
    json["evidence"] = json_t::object();
    for (const RankedCategory& c : spokenFor(map, i))
        json["evidence"][c.name] = {{"detectors", i.categories.sum().betaOf(c.category)},
                                    {"decisions", decidedFor(i, c.category)},
                                    {"probability", c.probability}};
    json["views"] = json_t::object();
    for (const auto& [category, views] : i.views.byCategory())
        for (const InstanceView& v : views)
            json["views"][map.categories().name(category)].push_back(toJson(map, v));
    json["history"] = json_t::array();
    for (const InstanceEvent& e : i.history)
        json["history"].push_back({{"frame", e.frame},
                                   {"event", nameOf(e.kind)},
                                   {"instance", e.instance},
                                   {"other", e.other}});
    json["decisions"] = json_t::array();
    for (const Decision& d : i.decisions) json["decisions"].push_back(toJson(map, d));
    return toText(json);
}
}  // namespace voxeland
