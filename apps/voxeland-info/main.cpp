// SPDX-License-Identifier: BSD-3-Clause
/** Tells what a map holds. */
#include "answers/AnswersAsText.h"
#include "answers/InstanceExplanation.h"
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/runProgram.h"
#include "planning/Reobservation.h"
#include "voxeland/answers/MapAnswers.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/map/CategorySearch.h"
#include "voxeland/map/SmallInstances.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Tells what a Voxeland map holds: a summary, or what one of the options asks for.

  voxeland-info kitchen.voxeland --instances            all objects, the biggest first
  voxeland-info kitchen.voxeland --instances --min-voxels 5      without specks
  voxeland-info kitchen.voxeland --find chair           where the chairs are, the nearest first
  voxeland-info kitchen.voxeland --find cup --from 1,2,0
  voxeland-info kitchen.voxeland --at 1.2,0.5,0.7       everything known of one place, and
                                                        the nearest object if none is there
  voxeland-info kitchen.voxeland --reobserve            what to look at again, and where from
  voxeland-info kitchen.voxeland --explain 12           why object 12 is what it is: evidence, views,
                                                        merges, splits, decisions

--find ignores case; in singular or plural; where no category has that name, part of one will do ("table" finds
"dining table"). Finding nothing is an answer, not an error. With --json, the same as JSON.
Coordinates are metres in the map's frame, entropies are in nat. Yaw and pitch of a camera are those of
MRPT (pitch > 0 looks down), in the map's frame turned about its origin until up is z.)";

/** Why nothing was found, and what could have been. */
std::string foundInstead(const CVoxelandMap& loaded, const std::string& wanted)
{
    const MapOverview overview = overviewOf(loaded.map(), loaded.counts());
    std::string text = whyNoneIsFound(loaded.map(), wanted) + "; it holds:";
    for (const auto& [name, count] : overview.categories)
        text += " " + name + " (" + std::to_string(count) + ")";
    return text + (overview.categories.empty() ? " no objects" : "");
}

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Switch json{*this, "--json", "Answer in JSON"};
    apps::Text up{
        *this, "--up", "X,Y,Z",
        "--reobserve: direction of up in the map's frame (default: estimated, +z if in doubt)"};
    apps::Number<double> cameraHeight{*this, "--camera-height", "METRES",
                                      "--reobserve: of the camera above the floor (default: 1.2)",
                                      CarriedCamera().height};
    apps::Number<size_t> most{*this, "--most", "N", "--reobserve: how many to name (default: 10)",
                              10};
    apps::Switch reobserve{
        *this, "--reobserve",
        "Objects and regions worth another look, the most uncertain first, and where to look from"};
    apps::Number<instance_id_t> explain{
        *this, "--explain", "ID", "Evidence, views, merges, splits and decisions of one object", 0};
    apps::Number<uint32_t> minVoxels{*this, "--min-voxels", "N",
                                     "Take instances of fewer occupied voxels for unknown", 0};
    apps::Text from{*this, "--from", "X,Y,Z",
                    "Where --find measures distances from (default: the map's origin)"};
    apps::Text at{*this, "--at", "X,Y,Z",
                  "Occupancy, instances, categories and entropies of the voxel at a place"};
    apps::Text find{*this, "--find", "CATEGORY", "Objects of a category, the nearest first"};
    apps::Switch instances{*this, "--instances", "Table of all objects, the biggest first"};
    apps::Text map{*this, "map", "MAP.voxeland", "Map to read", apps::Presence::required};
};

std::string summary(Arguments& arguments, const CVoxelandMap& loaded)
{
    const MapOverview overview = overviewOf(loaded.map(), loaded.counts());
    return arguments.json.isSet() ? asJson(loaded.map(), overview) : asText(overview);
}

std::string allInstances(Arguments& arguments, const CVoxelandMap& loaded)
{
    const auto all = listInstances(loaded.map());
    if (arguments.json.isSet()) return asJson(loaded.map(), all);
    return all.empty() ? "" : asText(all, false, loaded.map().options().prior_strength > 0);
}

std::string instancesOfCategory(Arguments& arguments, const CVoxelandMap& loaded)
{
    const SemanticVoxelMap& map = loaded.map();
    const auto origin = arguments.from.isSet() ? apps::parsePoint(arguments.from) : map.origin();
    const auto found = findInstances(map, arguments.find.value(), origin);
    if (found.empty()) arguments.note(foundInstead(loaded, arguments.find.value()));
    if (arguments.json.isSet()) return asJson(map, found);
    return found.empty() ? "" : asText(found, true, map.options().prior_strength > 0);
}

std::string place(Arguments& arguments, const CVoxelandMap& loaded)
{
    const PlaceAnswer answer = askPlace(loaded.map(), apps::parsePoint(arguments.at));
    return arguments.json.isSet() ? asJson(answer) : asText(answer);
}

std::string explanation(Arguments& arguments, const CVoxelandMap& loaded)
{
    const SemanticVoxelMap& map = loaded.map();
    const instance_id_t wanted = arguments.explain.value(), id = map.resolve(wanted);
    if (id == UNKNOWN_INSTANCE)
        throw ConfigurationError("--explain: there is no object " + std::to_string(wanted) +
                                 " in this map: see --instances");
    if (id != wanted)
        arguments.note("object " + std::to_string(wanted) + " was merged into object " +
                       std::to_string(id));
    return arguments.json.isSet() ? explanationAsJson(map, id) : explanationAsText(map, id);
}

std::string reobservation(Arguments& arguments, const CVoxelandMap& loaded)
{
    CarriedCamera camera;
    camera.height = arguments.cameraHeight.value();
    const GravityAlignedFrame frame(arguments.up.isSet() ? apps::parseDirection(arguments.up)
                                                         : estimateUp(loaded.map()));
    const auto targets = planReobservation(loaded.map(), frame, camera, arguments.most.value());
    return arguments.json.isSet() ? asJson(targets) : asText(targets);
}

/** Something a map can be asked: the option that asks it, and those that only go with it. */
struct Query
{
    const apps::Argument& asked;
    std::vector<const apps::Argument*> details;
    std::string (*answer)(Arguments& arguments, const CVoxelandMap& loaded);
};

std::vector<Query> queriesOf(const Arguments& a)
{
    return {
        {a.instances, {}, allInstances},
        {a.find, {&a.from}, instancesOfCategory},
        {a.at, {}, place},
        {a.explain, {}, explanation},
        {a.reobserve, {&a.up, &a.cameraHeight, &a.most}, reobservation},
    };
}

/** Complains about wrong usage before a map is read. */
void check(const Arguments& arguments)
{
    std::vector<std::string> asked;
    for (const Query& query : queriesOf(arguments)) {
        if (query.asked.isSet()) asked.push_back(query.asked.name());
        for (const auto* detail : query.details)
            if (detail->isSet() && !query.asked.isSet())
                throw ConfigurationError(detail->name() + " goes with " + query.asked.name());
    }
    if (asked.size() > 1) throw ConfigurationError("choose one of " + joined(asked, ", "));
    if (!(arguments.cameraHeight.value() > 0))
        throw ConfigurationError("--camera-height must be more than 0");
    for (const auto* point : {&arguments.from, &arguments.at})
        if (point->isSet()) static_cast<void>(apps::parsePoint(*point));
    if (arguments.up.isSet()) static_cast<void>(apps::parseDirection(arguments.up));
}

std::string answer(Arguments& arguments, const CVoxelandMap& loaded)
{
    for (const Query& query : queriesOf(arguments))
        if (query.asked.isSet()) return query.answer(arguments, loaded);
    return summary(arguments, loaded);
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    check(arguments);
    const auto loaded = loadMap(arguments.map.value());
    if (arguments.minVoxels.isSet())
        deactivateSmallInstances(loaded->editMap(), arguments.minVoxels.value());
    std::cout << answer(arguments, *loaded);
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-info", [&] { return run(argc, argv); });
}
