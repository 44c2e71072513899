// SPDX-License-Identifier: BSD-3-Clause
/** Tells what a map holds. */
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "voxeland/errors.h"
#include "voxeland/io/AnswersAsText.h"
#include "voxeland/io/MapAnswers.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION = R"(Tells what a Voxeland map holds: a summary, or one of

  voxeland-info kitchen.voxeland --instances            all objects, the biggest first
  voxeland-info kitchen.voxeland --find chair           where the chairs are, the nearest first
  voxeland-info kitchen.voxeland --find cup --from 1,2,0
  voxeland-info kitchen.voxeland --at 1.2,0.5,0.7       everything known of one place

--find ignores case; where no category has that name, part of one will do ("table" finds
"dining table"). Finding nothing is an answer, not an error. With --json, the same as JSON.
Coordinates are metres in the map's frame, entropies are in nat.)";

/** Says on stderr what could have been found. */
void listCategories(const MapOverview& overview, const std::string& wanted)
{
    std::cerr << "no '" << wanted << "' in this map; it holds:";
    for (const auto& [name, count] : overview.categories)
        std::cerr << " " << name << " (" << count << ")";
    std::cerr << (overview.categories.empty() ? " no objects\n" : "\n");
}

int run(int argc, char** argv)
{
    apps::CommandLine commandLine(DESCRIPTION);
    auto& parser = commandLine.parser();
    TCLAP::SwitchArg json("", "json", "Answer in JSON", parser);
    TCLAP::ValueArg<std::string> from("", "from",
                                      "Where --find measures distances from (default: the origin)",
                                      false, "", "X,Y,Z", parser);
    TCLAP::ValueArg<std::string> at(
        "", "at", "Occupancy, instances, categories and entropies of the voxel at a place", false,
        "", "X,Y,Z", parser);
    TCLAP::ValueArg<std::string> find("", "find", "Objects of a category, the nearest first", false,
                                      "", "CATEGORY", parser);
    TCLAP::SwitchArg instances("", "instances", "Table of all objects, the biggest first", parser);
    TCLAP::UnlabeledValueArg<std::string> mapFile("map", "Map to read", true, "", "MAP.voxeland",
                                                  parser);
    if (!commandLine.parse(argc, argv)) return 0;
    if (int{instances.isSet()} + int{find.isSet()} + int{at.isSet()} > 1)
        throw ConfigurationError("choose one of --instances, --find and --at");
    if (from.isSet() && !find.isSet())
        throw ConfigurationError("--from goes with --find, name a category");
    const auto origin =
        from.isSet() ? apps::parsePoint("from", from.getValue()) : mrpt::math::TPoint3D();
    const auto place = at.isSet() ? apps::parsePoint("at", at.getValue()) : mrpt::math::TPoint3D();

    const auto loaded = loadMap(mapFile.getValue());
    const SemanticVoxelMap& map = loaded->map();
    const bool prior = map.options().prior_strength > 0;
    if (instances.isSet() || find.isSet()) {
        const auto found =
            find.isSet() ? findInstances(map, find.getValue(), origin) : listInstances(map);
        if (found.empty() && find.isSet())
            listCategories(overviewOf(map, loaded->counts()), find.getValue());
        if (json.isSet())
            std::cout << asJson(map, found);
        else if (!found.empty())
            std::cout << asText(found, find.isSet(), prior);
    } else if (at.isSet()) {
        const PlaceAnswer answer = askPlace(map, place);
        std::cout << (json.isSet() ? asJson(answer) : asText(answer));
    } else {
        const MapOverview overview = overviewOf(map, loaded->counts());
        std::cout << (json.isSet() ? asJson(map, overview) : asText(overview));
    }
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-info", [&] { return run(argc, argv); });
}
