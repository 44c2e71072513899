// SPDX-License-Identifier: BSD-3-Clause
/** Writes a map in formats that other programs read. */
#include "base/ClassicNumbers.h"
#include "common/CommandLine.h"
#include "common/PointArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"
#include "voxeland/exporters/Exporter.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/map/CategorySearch.h"
#include "voxeland/map/SmallInstances.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <iostream>
#include <set>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION = R"(Writes a Voxeland map in formats that other programs read.

  voxeland-export -m kitchen.voxeland --png-dir pictures --min-voxels 10
  voxeland-export -m kitchen.voxeland --ply kitchen.ply --json kitchen.json --csv kitchen.csv
  voxeland-export -m kitchen.voxeland --glb kitchen.glb --scene kitchen.3Dscene
  voxeland-export -m flat.voxeland --octomap flat.bt --gridmap flat.gridmap --ros-map flat.yaml
  voxeland-export -m flat.voxeland --points chairs.txt --category chair --height 0.1,1.2
  voxeland-export -m flat.voxeland --points obstacles.metricmap --except person --height 0.1,1.2

At least one output must be named. Existing files are replaced once the new ones are complete.
Coordinates are metres in the map's frame; entropies are in nat. Grids, and nothing else, are in that
frame turned about its origin until up is z, and heights are measured along up from the floor, the
lowest surface that was seen: both are told where they matter.)";

/** The option of each of exporters(), in their order. */
struct Outputs
{
    explicit Outputs(apps::CommandLine& line)
    {
        for (const Exporter& e : exporters())
            options.emplace_back(line, "--" + e.name, e.value, e.description);
    }
    std::deque<apps::Text> options;
};

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Text up{*this, "--up", "X,Y,Z",
                  "Direction of up in the map's frame (default: +z, or that direction near it in "
                  "which floor and tables are level, or -y in a world with a camera's axes)"};
    apps::Text height{*this, "--height", "LOW,HIGH",
                      "Heights above the floor [m] of --gridmap and --ros-map (default: 0.1,1.8) "
                      "and --points (default: all)"};
    apps::Texts category{*this, "--category", "NAME",
                         "--points: only of this category; may be repeated"};
    apps::Texts except{*this, "--except", "NAME",
                       "--points: not of this category; may be repeated"};
    apps::Number<uint32_t> minVoxels{
        *this, "--min-voxels", "N",
        "Take instances of fewer occupied voxels for unknown, in all outputs", 0};
    apps::Switch all{*this, "--all",
                     "PLY: also voxels that were measured once but are now believed free"};
    Outputs outputs{*this};
    apps::Text map{*this, "-m,--map", "MAP.voxeland", "Map to read", apps::Presence::required};

    /** An output that was asked for. */
    struct Asked
    {
        const Exporter& exporter;
        std::string output;
    };
    [[nodiscard]] std::vector<Asked> asked() const
    {
        std::vector<Asked> all;
        for (size_t i = 0; i < exporters().size(); ++i)
            if (outputs.options[i].isSet())
                all.push_back({exporters()[i], outputs.options[i].value()});
        return all;
    }
};

/** Tries to write one format after another: what one of them cannot hold, or cannot be written,
 * keeps none of the others from being written. */
class Attempts
{
 public:
    void attempt(const std::function<void()>& write)
    {
        try {
            write();
        } catch (const ConfigurationError& e) {
            const std::string what = e.what();  // two of one kind may say the same
            if (std::find(m_refusals.begin(), m_refusals.end(), what) == m_refusals.end())
                m_refusals.push_back(what);
        } catch (const OutputError& e) {
            m_failures.emplace_back(e.what());
        }
    }
    /** Those completed; each is told on stdout. */
    [[nodiscard]] WrittenFiles& written() { return m_written; }
    /** \throws OutputError that tells what failed first and what is complete, if anything failed,
     *  ConfigurationError that tells what was refused, if anything was */
    void finish() const
    {
        if (!m_failures.empty()) throw OutputError(m_failures.front() + m_written.told());
        if (!m_refusals.empty()) throw ConfigurationError(joined(m_refusals, "; "));
    }

 private:
    std::vector<std::string> m_refusals, m_failures;
    WrittenFiles m_written{[](const std::string& file) {
        std::cout << "written: " << printable(file, UNCUT) << "\n";
    }};
};

/** Whether any object is of a category, or that is *unknown*. */
bool isInMap(const SemanticVoxelMap& map, const std::string& name)
{
    const auto fits = [&](const std::string& category) {
        return nameFit(name, category) >= NameFit::plural;
    };
    const auto instances = summarizeInstances(map);
    return fits(UNKNOWN_CATEGORY) ||
           std::any_of(instances.begin(), instances.end(),
                       [&](const InstanceSummary& s) { return fits(s.category()); });
}

/** What the options say to all exporters. */
ExportSettings settingsOf(const Arguments& arguments, const SemanticVoxelMap& map)
{
    ExportSettings settings;
    settings.frame = GravityAlignedFrame(arguments.up.isSet() ? apps::parseDirection(arguments.up)
                                                              : estimateUp(map));
    if (arguments.height.isSet()) settings.heights = apps::parseHeights(arguments.height);
    for (const std::string& name : arguments.category.values()) settings.categories.insert(name);
    for (const std::string& name : arguments.except.values()) settings.except.insert(name);
    settings.occupiedOnly = !arguments.all.isSet();
    settings.note = [&arguments, told = std::set<std::string>()](const std::string& text) mutable {
        if (told.insert(text).second) arguments.note(text);
    };
    settings.warn = [&arguments](const std::string& text) { arguments.warn(text); };
    return settings;
}

void writeAll(const Arguments& arguments, const SemanticVoxelMap& map)
{
    const ExportSettings settings = settingsOf(arguments, map);
    for (const auto* names : {&settings.categories, &settings.except})
        for (const std::string& name : *names)
            if (!isInMap(map, name)) arguments.warn(whyNoneIsFound(map, name));
    Attempts attempts;
    for (const Arguments::Asked& asked : arguments.asked())
        attempts.attempt(
            [&] { asked.exporter.write(map, settings, asked.output, attempts.written()); });
    attempts.finish();
}

/** The options of the exporters that have a property, for messages. */
std::string optionsOf(bool Exporter::*property)
{
    std::vector<std::string> names;
    for (const Exporter& e : exporters())
        if (e.*property) names.push_back("--" + e.name);
    return joined(names, " or ");
}

/** Complains about wrong usage before a map is read. */
void check(const Arguments& arguments)
{
    const auto asked = arguments.asked();
    if (asked.empty())
        throw ConfigurationError("nothing to write: name at least one output (see --help)");
    const auto complainUnless = [&](bool Exporter::*property, const char* options) {
        const bool any = std::any_of(asked.begin(), asked.end(), [&](const Arguments::Asked& a) {
            return a.exporter.*property;
        });
        if (!any) throw ConfigurationError(std::string(options) + " with " + optionsOf(property));
    };
    if (arguments.category.isSet() || arguments.except.isSet())
        complainUnless(&Exporter::takesCategories, "--category and --except go");
    if (arguments.up.isSet()) static_cast<void>(apps::parseDirection(arguments.up));
    if (arguments.height.isSet()) {
        static_cast<void>(apps::parseHeights(arguments.height));
        complainUnless(&Exporter::takesHeights, "--height goes");
    }
    apps::NamedFiles outputs;
    for (const auto& [exporter, output] : asked) {
        checkEnding(exporter, output);
        if (exporter.writesFolder()) makeOutputFolder(output);
        (exporter.writesFolder() ? outputs.folders : outputs.files).push_back(output);
        if (exporter.beside != nullptr) outputs.files.push_back(exporter.beside(output));
    }
    apps::checkOutputs(outputs, {{arguments.map.value()}, {}, {}});
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    check(arguments);

    const auto loaded = loadMap(arguments.map.value());
    if (arguments.minVoxels.isSet())
        deactivateSmallInstances(loaded->editMap(), arguments.minVoxels.value());
    writeAll(arguments, loaded->map());
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-export", [&] { return run(argc, argv); });
}
