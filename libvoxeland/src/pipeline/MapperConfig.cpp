// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/MapperConfig.h"

#include "PoseSource.h"
#include "plugins/PluginLoader.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/nearestWord.h"
#include "voxeland/base/printable.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>

namespace voxeland
{
namespace
{
constexpr double INF = std::numeric_limits<double>::infinity();

void declare(OptionList& list, InputOptions& o)
{
    list.add("depth_sensor_label", o.depth_sensor_label,
             "Sensor label of the RGB-D camera; empty: the first CObservation3DRangeScan met",
             OptionList::anyValue);
    list.add("instances_sensor_label", o.instances_sensor_label,
             "Sensor label of the predictions; empty: that of the camera, or else the first met",
             OptionList::anyValue);
    list.add(
        "pose_source", o.pose_source,
        "Where robot poses come from: robot_pose | odometry | actions | tum:<file>; those of a "
        "simplemap are its keyframes', unless tum:<file>",
        [](const std::string& source) { return !isTumPoseSource(source); });
    list.add(
        "pose_axes", o.pose_axes, poseAxesByName(),
        "What those poses are of: body, the robot (x forward, y left, z up); optical, the "
        "depth camera (x right, y down, z forward); opengl, it too (x right, y up, z backward); "
        "of actions and simplemaps always body");
    list.add("min_depth", o.depth.min_depth, {0, INF}, "Nearest depth used [m]");
    list.add("max_depth", o.depth.max_depth, {0, 1000}, "Farthest depth used [m]");
    list.add("threads", o.threads, {0, 256},
             "Threads that read and prepare frames; 0: one a core. The map does not depend on it");
    list.concernsRun();
    list.forExperts();
    list.add("pose_sensor_label", o.pose_sensor_label,
             "Sensor label of the robot poses; empty: the first CObservationRobotPose met",
             OptionList::anyValue);
    list.add("max_pose_gap", o.max_pose_gap, {0, INF},
             "Longest time between two poses to interpolate over [s]");
    list.add("prediction_wait", o.prediction_wait, {0, 1000},
             "How many newer frames to wait for a frame's predictions or pose");
}

void declare(OptionList& list, MapOptions& o, IntegrationOptions& integration)
{
    list.add("resolution", o.resolution, {0.001, 10}, "Voxel edge [m]");
    list.add("pose_uncertainty", integration.pose_uncertainty,
             "Where poses come with a covariance, evidence counts by the probability that it is in "
             "the right voxel");
    list.forExperts();
    list.add("prob_hit", o.occupancy.prob_hit, {0.5, 1},
             "Probability of occupied, given a point measured in the voxel");
    list.add("prob_miss", o.occupancy.prob_miss, {0, 0.5},
             "Probability of occupied, given a ray through the voxel");
    list.add("prob_min", o.occupancy.prob_min, {0, 0.5}, "Least probability a voxel can reach");
    list.add("prob_max", o.occupancy.prob_max, {0.5, 1}, "Greatest probability a voxel can reach");
    list.add("membership", o.membership, {0, 1},
             "A voxel is part of an instance that has this share of its evidence for instances");
    list.add("evidence", integration.evidence,
             std::vector<std::pair<std::string, EvidenceRule>>{{"novelty", EvidenceRule::novelty},
                                                               {"sum", EvidenceRule::sum}},
             "What counts: novelty, an opinion by what it adds to those about the same side of an "
             "object, a point likewise to those of its frame in the same voxel; sum, as in the "
             "paper, each opinion and each point");
    list.add("unknown_weight", integration.unknown_weight, {0, 1},
             "Evidence for 'unknown' of a depth pixel that no detection claims");
    list.add("missed_share", integration.missed_share, {0, 1},
             "Where more than this share of an instance is in view but no detection is about it, "
             "the detector missed it: its voxels get no evidence for 'unknown'; 1: never");
    list.add("sharpness", integration.sharpness, {1, 100},
             "Exponent of category probabilities before they count as evidence; large: the most "
             "probable category alone, as in the paper");
    list.add("visibility_margin", integration.visibility_margin, {0, 10},
             "A voxel this far behind the measured depth still counts as seen [m]");
    list.add("prior_strength", o.prior_strength, {0, INF},
             "Prior evidence spread over the known categories of an instance (W)");
    list.add(
        "entropy", o.entropy,
        std::vector<std::pair<std::string, EntropyMeasure>>{{"expected", EntropyMeasure::expected},
                                                            {"paper", EntropyMeasure::paper},
                                                            {"mean", EntropyMeasure::mean}},
        "Measure of uncertainty [nat]");
    list.add("views_kept", o.views_kept, {0, 100},
             "Best views an instance keeps of each category, for voxeland-disambiguate");
    list.retire("view_categories");
}

void declare(OptionList& list, RefinementOptions& o)
{
    list.add("every", o.every, {0, 1e6}, "Frames between two refinements of the map; 0: never");
    list.add("min_evidence", o.min_evidence, {0, INF},
             "Instances with less evidence (sum of their detections' scores) count as unknown ...");
    list.add("patience", o.patience, {0, 1e6},
             "... when not seen for so many frames; they come back when seen again");
    list.forExperts();
    list.add("merge_iou", o.merge.iou, {0, 1},
             "Instances with a greater intersection over union are merged");
    list.add("merge_ios", o.merge.ios, {0, 1},
             "So are those with this intersection over smaller ...");
    list.add("merge_similarity", o.merge.similarity, {0, 1}, "... and this semantic similarity");
    list.add("dbscan_eps", o.dbscan_eps, {1, 10},
             "Voxels up to this far along each axis are neighbours [voxels]");
    list.add("dbscan_min_points", o.dbscan_min_points, {1, 1000},
             "Voxels within that neighbourhood that make a voxel a core of a cluster");
    list.add("min_part_voxels", o.min_part_voxels, {1, 1e6},
             "Smaller parts do not become instances [voxels]");
    list.add("min_part_share", o.min_part_share, {0, 1},
             "Nor do parts with a smaller share of the instance's voxels");
    // Merging by intersection over smaller; merging only what is connected; dividing what fell
    // apart.
    list.addAblation({{"ios", o.merge.use_ios, "use_ios"},
                      {"continuity", o.continuity, "continuity"},
                      {"split", o.split, "split"}});
}

void declare(OptionList& list, CalibrationOptions& o)
{
    list.add("words", o.words,
             "Table of what the detector's words mean, as voxeland-calibrate writes it; empty: "
             "themselves, or what a resumed map says");
    list.concernsRun();
    list.forExperts();
    list.add("agreement", o.agreement, {1, Calibration::MOST_AGREEMENT},
             "How much words that agree make each other more credible, of that table");
    list.concernsRun();
}

void declare(OptionList& list, DisambiguationOptions& o)
{
    list.add("entropy_threshold", o.entropy_threshold, {0, INF},
             "Instances whose category is more uncertain are asked about; depends on [map] "
             "entropy [nat]");
    list.add("min_voxels", o.min_voxels, {1, 1e6}, "Smaller instances are not asked about");
    list.add("max_questions", o.max_questions, {0, 1e6},
             "Questions of a run, the most uncertain instances first; 0: no limit");
    list.add("views_per_category", o.views_per_category, {1, 100},
             "Pictures of each candidate's views");
    list.forExperts();
    list.add("ask_again", o.ask_again, "Also ask about instances that have a decision");
    list.add("max_categories", o.max_categories, {1, 100}, "Candidates of a question");
    list.add("crop_margin", o.crop_margin, {0, 10},
             "Margin around the object, in shares of its longer side");
    list.add("picture_size", o.picture_size, {64, 8192}, "Longer side of a picture [pixels]");
    list.add("whole_frame", o.whole_frame, "Also show the best view's whole frame");
    list.add("voxel_picture", o.voxel_picture, "Also show the object's voxels");
    list.add("prompt", o.prompt,
             "File of the prompt's template; empty: the built-in one, share/prompts/"
             "disambiguate.txt");
    list.add("max_attempts", o.max_attempts, {1, 100}, "Times to ask until an answer can be used");
    list.add("parallel", o.parallel, {1, 64}, "Questions asked at a time");
    list.add("answer_reliability", o.answer_reliability, {0.5, 0.999},
             "Share of its answers that are right: an answer is evidence of that, beside what the "
             "map knew");
    list.add("prompt_price", o.prompt_price, {0, INF}, "Price of a million tokens of questions");
    list.add("answer_price", o.answer_price, {0, INF}, "Price of a million tokens of answers");
    list.retire("decision_weight");
    list.retire("view_selection");
    list.retire("seed");
}

/** What is wrong with an INI. */
struct Problems
{
    std::vector<std::string> settings, plugins;

    /** As many as a person reads. */
    static std::string listed(const std::vector<std::string>& all)
    {
        constexpr size_t LONGEST = 800;
        std::string text;
        for (size_t i = 0; i < all.size(); ++i) {
            const std::string next = printableSentence(all[i]);
            if (i > 0 && text.size() + next.size() > LONGEST)
                return text + "; and " + counted(all.size() - i, "more problem");
            text += (i == 0 ? "" : "; ") + next;
        }
        return text;
    }

    /** Throws what there is, all in one message. */
    void report(const std::string& origin) const
    {
        std::vector<std::string> all = plugins;
        all.insert(all.end(), settings.begin(), settings.end());
        if (all.empty()) return;
        const std::string message =
            "configuration of '" + printableSentence(origin) + "': " + listed(all);
        if (!plugins.empty()) throw PluginError(message);
        throw ConfigurationError(message);
    }
};

/** A section that names a plugin class, of which library if it is not a shipped one, and that
 * class's keys. */
template <typename Base>
struct PluginSection
{
    std::string section, library, className;
    OptionList options;
    std::shared_ptr<Base> object;

    /** \param declareOthers declares the section's keys that no plugin owns */
    PluginSection(const Ini& ini, std::string name, const std::string& defaultClass,
                  Problems& problems, bool isNeeded,
                  const std::function<void(OptionList&)>& declareOthers = nullptr)
        : section(std::move(name))
    {
        // These two decide which other keys there are, so they are read first.
        OptionList choice;
        std::vector<std::string> reportedLater;
        choice.add("class", className, "", OptionList::anyValue);
        choice.add("plugin", library, "");
        choice.load(ini, section, reportedLater);
        try {
            object = created(ini, defaultClass);
        } catch (const PluginError& e) {
            if (isNeeded || !ini.isOfMap(section, "class"))
                problems.plugins.push_back(whyNone(e, ini));
            return;  // which other keys there are is not known
        }
        options.add("class", className, object->description(), OptionList::anyValue);
        options.add("plugin", library, "Library of the class; empty: it is a shipped one");
        if (declareOthers) declareOthers(options);
        options.forExperts(false);
        object->declareOptions(options);
        options.load(ini, section, problems.settings);
    }

 private:
    [[nodiscard]] std::string whyNone(const PluginError& e, const Ini& ini) const
    {
        const std::string named =
            ini.isOfMap(section, "plugin") ? ini.value(section, "plugin") : "";
        if (named.empty()) return e.what();
        return "the class '" + printable(className) + "' is of the library '" + printable(named) +
               "', which a map does not get loaded: give the key 'plugin' of [" + section +
               "] again, with -c or --set";
    }

    std::shared_ptr<Base> created(const Ini& ini, const std::string& defaultClass)
    {
        if (!library.empty()) {
            auto plugin = createPlugin<Base>(className, library, pluginSearchPath(ini.folder()));
            if (className.empty()) className = plugin->GetRuntimeClass()->className;
            return plugin;
        }
        if (className.empty()) className = defaultClass;
        return createPlugin<Base>(className);
    }
};

/** The calibration that is named, if any. A relative name is looked for beside the INI first. */
std::optional<Calibration> calibrationOf(const CalibrationOptions& options, const Ini& ini,
                                         std::vector<std::string>& problems)
{
    if (options.words.empty()) return std::nullopt;
    std::error_code error;
    const auto beside = std::filesystem::path(ini.folder()) / options.words;
    try {
        return Calibration::fromCsv(
            std::filesystem::exists(beside, error) ? beside.string() : options.words,
            options.agreement);
    } catch (const InputError& e) {
        problems.push_back(std::string("[calibration] words: ") + e.what());
        return std::nullopt;
    }
}

/** What of a map's configuration is left out, in a sentence; empty if nothing is. */
std::string leftToUser(const std::vector<const OptionList*>& lists, const std::string& map)
{
    std::vector<std::string> all;
    for (const OptionList* list : lists)
        for (const std::string& setting : list->leftToUser()) all.push_back(printable(setting));
    if (all.empty()) return {};
    return "'" + map + "' is only a map and may not choose files, servers or libraries: left out " +
           joined(all, ", ") + "; if that is right, give it yourself in an INI or with --set";
}

void checkSections(const Ini& ini, std::vector<std::string>& problems)
{
    const auto& known = MapperConfig::sections();
    for (const std::string& key : ini.keys(""))
        problems.push_back("key '" + key + "' stands before any [section]");
    for (const std::string& section : ini.sections()) {
        if (section.empty() || std::find(known.begin(), known.end(), section) != known.end())
            continue;
        const std::string nearest = nearestWord(section, known);
        problems.push_back("there is no section [" + section + "]" +
                           (nearest.empty() ? "" : " (did you mean [" + nearest + "]?)"));
    }
}
}  // namespace

const std::vector<std::string>& MapperConfig::sections()
{
    static const std::vector<std::string> names = {"voxeland",      "map",         "calibration",
                                                   "converter",     "association", "refinement",
                                                   "disambiguation"};
    return names;
}

MapperConfig::MapperConfig(const Ini& ini, Purpose purpose, const Tell& tell)
{
    const bool maps = purpose == Purpose::mapping;
    Problems problems;
    checkSections(ini, problems.settings);
    CalibrationOptions calibrationOptions;
    OptionList inputList, mapList, calibrationList, refinementList;
    declare(inputList, input);
    declare(mapList, map, integration);
    declare(calibrationList, calibrationOptions);
    declare(refinementList, refinement);
    inputList.load(ini, "voxeland", problems.settings);
    mapList.load(ini, "map", problems.settings);
    calibrationList.load(ini, "calibration", problems.settings);
    refinementList.load(ini, "refinement", problems.settings);
    calibration = calibrationOf(calibrationOptions, ini, problems.settings);
    if (input.depth.min_depth >= input.depth.max_depth)
        problems.settings.push_back("[voxeland] min_depth must be less than max_depth");
    if (const std::string problem = problemOfPoseSource(input.pose_source); !problem.empty())
        problems.settings.push_back(problem);
    try {
        OccupancyFilter check(map.occupancy);
    } catch (const std::invalid_argument& e) {
        problems.settings.push_back(std::string("[map] ") + e.what());
    }

    PluginSection<COpinionConverter> converterSection(
        ini, "converter", "CRecordedInstancesConverter", problems, maps);
    PluginSection<CAssociationPolicy> associationSection(ini, "association",
                                                         "CEvidentialAssociation", problems, maps);
    PluginSection<CDisambiguator> disambiguationSection(
        ini, "disambiguation", "CTopCategoryDisambiguator", problems, !maps,
        [this](OptionList& list) { declare(list, disambiguation); });
    std::vector<const OptionList*> needed = {&disambiguationSection.options};
    if (maps)
        needed = {&inputList,
                  &mapList,
                  &calibrationList,
                  &converterSection.options,
                  &associationSection.options,
                  &refinementList};
    if (const std::string left = leftToUser(needed, ini.mapName()); tell && !left.empty())
        tell(left);
    problems.report(ini.origin());
    if (maps) {
        converterSection.object->start();
        associationSection.object->start();
    }
    converter = converterSection.object;
    association = associationSection.object;
    disambiguator = disambiguationSection.object;

    const std::vector<std::pair<const char*, const OptionList*>> lists = {
        {"voxeland", &inputList},
        {"map", &mapList},
        {"calibration", &calibrationList},
        {"converter", &converterSection.options},
        {"association", &associationSection.options},
        {"refinement", &refinementList},
        {"disambiguation", &disambiguationSection.options}};
    const auto print = [&](OptionList::Keys keys) {
        std::ostringstream out;
        for (const auto& [section, list] : lists) {
            if (list != &inputList) out << "\n";
            list->print(out, section, keys);
        }
        return out.str();
    };
    m_text = print(OptionList::Keys::all);
    m_commonText = print(OptionList::Keys::common);
    m_reproducibleText = print(OptionList::Keys::ofMap);
}
}  // namespace voxeland
