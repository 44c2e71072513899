// SPDX-License-Identifier: BSD-3-Clause
#include "ViewColoring.h"

#include "voxeland/map/MapQueries.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace voxeland
{
namespace
{
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
    for (const SceneVoxel& v : scene.voxels()) coloring.colors.push_back(instanceColor(v.winner));
    const auto& axes = scene.mapAxes();
    for (const InstanceSummary& s : bySize(map)) {
        coloring.legend.push_back(
            {instanceColor(s.id),
             mrpt::format("%u %s %.2f", s.id, s.category().c_str(), s.probability())});
        const mrpt::math::TPoint3Df c(s.centroid);
        coloring.labels.push_back(
            {axes[0] * c.x + axes[1] * c.y + axes[2] * c.z, std::to_string(s.id)});
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
    for (const SceneVoxel& v : scene.voxels()) {
        const auto at = categoryOf.find(v.winner);
        coloring.colors.push_back(at == categoryOf.end() ? UNKNOWN_COLOR : palette.at(at->second));
    }
    for (const auto& [name, color] : palette)
        coloring.legend.push_back({color, mrpt::format("%s (%u)", name.c_str(), counts[name])});
    coloring.legend.push_back({UNKNOWN_COLOR, UNKNOWN_CATEGORY});
    return coloring;
}

/** Red end of the colour bar: the 99 % quantile of the values, so that strays do not decide. */
double barMaximum(std::vector<double> values)
{
    constexpr double LEAST = 0.05, SHARE = 0.99;
    if (values.empty()) return LEAST;
    const auto n = static_cast<long>(SHARE * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + n, values.end());
    return std::max(LEAST, values[static_cast<size_t>(n)]);
}

/** \param value of a voxel [nat] \param isGrey voxels that nothing can be said of */
ViewColoring byUncertainty(const std::string& name, const std::string& title,
                           const VoxelScene& scene,
                           const std::function<double(const VoxelEvidence&)>& value,
                           const std::function<bool(const SceneVoxel&)>& isGrey)
{
    ViewColoring coloring{"uncertainty_" + name, title, {}, {}, {}};
    std::vector<double> values;
    for (const SceneVoxel& v : scene.voxels())
        if (!isGrey(v)) values.push_back(value(*v.evidence));
    coloring.barMaximum = barMaximum(values);
    size_t next = 0;
    for (const SceneVoxel& v : scene.voxels())
        coloring.colors.push_back(
            isGrey(v) ? UNKNOWN_COLOR : uncertaintyColor(values[next++] / coloring.barMaximum));
    coloring.legend.push_back({UNKNOWN_COLOR, "no detection"});
    return coloring;
}
}  // namespace

std::vector<ViewColoring> colorings(const SemanticVoxelMap& map, const VoxelScene& scene)
{
    VoxelUncertainty uncertainty(map);
    const auto onlyUnknown = [](const SceneVoxel& v) {
        return !v.isObject() && v.evidence->size() <= 1;
    };
    const auto wonByUnknown = [](const SceneVoxel& v) { return !v.isObject(); };
    return {
        byInstance(map, scene), byCategory(map, scene),
        byUncertainty(
            "instances", "Uncertainty: which instance a voxel belongs to", scene,
            [&](const VoxelEvidence& e) { return uncertainty.instanceEntropy(e); }, onlyUnknown),
        byUncertainty(
            "categories", "Uncertainty: which category an instance is of", scene,
            [&](const VoxelEvidence& e) { return uncertainty.winnerCategoryEntropy(e); },
            wonByUnknown),
        byUncertainty(
            "semantic", "Uncertainty: which category a voxel is of", scene,
            [&](const VoxelEvidence& e) { return uncertainty.categoryEntropy(e); }, onlyUnknown)};
}
}  // namespace voxeland
