// SPDX-License-Identifier: BSD-3-Clause
#include "ViewColoring.h"

#include "base/ClassicNumbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/map/MapQueries.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace voxeland
{
namespace
{
constexpr size_t LONGEST_NAME = 40;
constexpr uint32_t LABELLED = 5;  //!< voxels an instance must have for a label in the picture

/** The biggest instances first. */
std::vector<InstanceSummary> bySize(const SemanticVoxelMap& map)
{
    auto summaries = summarizeInstances(map);
    std::stable_sort(summaries.begin(), summaries.end(),
                     [](const auto& a, const auto& b) { return a.voxels > b.voxels; });
    return summaries;
}

ViewColoring byInstance(const SemanticVoxelMap& map, const VoxelScene& scene)
{
    ViewColoring coloring{"instances", "Instances", {}, {}, {}};
    const auto palette = instanceColors(map);
    coloring.colors.reserve(scene.voxels().size());
    for (const SceneVoxel& v : scene.voxels()) coloring.colors.push_back(palette.at(v.winner));
    for (const InstanceSummary& s : bySize(map)) {
        coloring.legend.push_back(
            {palette.at(s.id),
             format("%u %s %.2f", s.id, printable(s.category(), LONGEST_NAME).c_str(),
                    s.probability())});
        if (s.voxels >= LABELLED)
            coloring.labels.push_back({scene.toLevel(map.inMap(s.centroid)), std::to_string(s.id)});
    }
    coloring.legend.push_back({UNKNOWN_COLOR, UNKNOWN_CATEGORY});
    return coloring;
}

ViewColoring byCategory(const SemanticVoxelMap& map, const VoxelScene& scene)
{
    ViewColoring coloring{"categories", "Categories", {}, {}, {}};
    std::map<instance_id_t, std::string> categoryOf;
    std::map<std::string, unsigned> counts;
    std::set<std::string> names;
    for (const InstanceSummary& s : summarizeInstances(map)) {
        if (s.categories.empty()) continue;
        categoryOf[s.id] = s.category();
        names.insert(s.category());
        ++counts[s.category()];
    }
    const auto palette = categoryColors(names);
    coloring.colors.reserve(scene.voxels().size());
    for (const SceneVoxel& v : scene.voxels()) {
        const auto at = categoryOf.find(v.winner);
        coloring.colors.push_back(at == categoryOf.end() ? UNKNOWN_COLOR : palette.at(at->second));
    }
    for (const auto& [name, color] : palette)
        coloring.legend.push_back(
            {color, format("%s (%u)", printable(name, LONGEST_NAME).c_str(), counts[name])});
    coloring.legend.push_back({UNKNOWN_COLOR, UNKNOWN_CATEGORY});
    return coloring;
}

/** One of the uncertainties of a map's voxels. */
struct Uncertainty
{
    std::string name, title;
    std::function<double(const VoxelEvidence&)> value;  //!< [nat]
    std::function<bool(const SceneVoxel&)> isGrey;      //!< nothing can be said of the voxel
};

/** Red end of the colour bar: the 99 % quantile of the values, so that strays do not decide. Keeps
 * those above it alone, as maps have millions. */
double barMaximum(const Uncertainty& uncertainty, const VoxelScene& scene)
{
    constexpr double LEAST = 0.05, SHARE = 0.99;
    const auto count = std::count_if(scene.voxels().begin(), scene.voxels().end(),
                                     [&](const SceneVoxel& v) { return !uncertainty.isGrey(v); });
    if (count == 0) return LEAST;
    const auto below = static_cast<long>(SHARE * static_cast<double>(count - 1));
    std::priority_queue<double, std::vector<double>, std::greater<>> highest;
    for (const SceneVoxel& v : scene.voxels()) {
        if (uncertainty.isGrey(v)) continue;
        highest.push(uncertainty.value(*v.evidence));
        if (highest.size() > static_cast<size_t>(count - below)) highest.pop();
    }
    return std::max(LEAST, highest.top());
}

ViewColoring byUncertainty(const Uncertainty& uncertainty, const VoxelScene& scene,
                           double barMaximum)
{
    ViewColoring coloring{"uncertainty_" + uncertainty.name, uncertainty.title, {}, {}, {}};
    coloring.barMaximum = barMaximum;
    coloring.colors.reserve(scene.voxels().size());
    for (const SceneVoxel& v : scene.voxels())
        coloring.colors.push_back(
            uncertainty.isGrey(v) ? UNKNOWN_COLOR
                                  : uncertaintyColor(uncertainty.value(*v.evidence) / barMaximum));
    coloring.legend.push_back({UNKNOWN_COLOR, "no detection"});
    return coloring;
}
}  // namespace

void forEachColoring(const SemanticVoxelMap& map, const VoxelScene& scene,
                     const std::function<void(const ViewColoring&)>& draw)
{
    draw(byInstance(map, scene));
    draw(byCategory(map, scene));
    VoxelUncertainty entropies(map);
    const auto onlyUnknown = [](const SceneVoxel& v) {
        return !v.isObject() && v.evidence->size() <= 1;
    };
    const auto wonByUnknown = [](const SceneVoxel& v) { return !v.isObject(); };
    const std::vector<Uncertainty> uncertainties = {
        {"instances", "Uncertainty: which instance a voxel belongs to",
         [&](const VoxelEvidence& e) { return entropies.instanceEntropy(e); }, onlyUnknown},
        {"categories", "Uncertainty: which category an instance is of",
         [&](const VoxelEvidence& e) { return entropies.winnerCategoryEntropy(e); }, wonByUnknown},
        {"semantic", "Uncertainty: which category a voxel is of",
         [&](const VoxelEvidence& e) { return entropies.categoryEntropy(e); }, onlyUnknown}};
    // One scale for all, so that the pictures can be compared. The last one is left out: it is
    // large where few measurements leave all categories open, and would make all others blue.
    const double maximum =
        std::max(barMaximum(uncertainties[0], scene), barMaximum(uncertainties[1], scene));
    for (const Uncertainty& u : uncertainties) draw(byUncertainty(u, scene, maximum));
}
}  // namespace voxeland
