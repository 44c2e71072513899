// SPDX-License-Identifier: BSD-3-Clause
#include "ReportData.h"

#include "base/ClassicNumbers.h"
#include "pictures/Colors.h"
#include "pictures/MapViews.h"
#include "voxeland/answers/MapAnswers.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"
#include "voxeland/level/UpDirection.h"

#include <mrpt/core/format.h>
#include <mrpt/system/string_utils.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using nlohmann::json;

namespace voxeland
{
namespace
{
std::string base64(const std::vector<uint8_t>& bytes)
{
    std::string text;
    mrpt::system::encodeBase64(bytes, text);
    return text;
}

template <typename T>
void append(std::vector<uint8_t>& bytes, T value)
{
    for (size_t i = 0; i < sizeof(T); ++i)
        bytes.push_back(static_cast<uint8_t>(static_cast<uint64_t>(value) >> (8 * i)));
}

std::string hex(const Color& c)
{
    return format("#%02x%02x%02x", c.red, c.green, c.blue);
}

json list(const mrpt::math::TPoint3D& p)
{
    return {p.x, p.y, p.z};
}

json summaryOf(const SemanticVoxelMap& map, const MappingCounts& counts)
{
    const MapOverview o = overviewOf(map, counts);
    const auto size = o.boxMax - o.boxMin;
    return json::array(
        {{"objects", format("%zu", o.instances)},
         {"categories", format("%zu", o.categories.size())},
         {"frames", format("%u", counts.frames)},
         {"detections used", format("%u", counts.opinions)},
         {"extent", format("%.1f x %.1f x %.1f m", size.x, size.y, size.z)},
         {"voxels", format("%zu surface, %zu observed", o.occupiedVoxels, o.observedVoxels)},
         {"resolution", format("%g m", o.resolution)}});
}

json instancesOf(const SemanticVoxelMap& map, const std::vector<FoundInstance>& instances)
{
    const auto colors = instanceColors(map);
    std::set<std::string> names;
    for (const FoundInstance& f : instances) names.insert(f.summary.category());
    const auto categoryPalette = categoryColors(names);
    json all = json::array();
    for (const auto& [s, box, distance] : instances) {
        json probabilities = json::array();
        constexpr size_t SHOWN = 5;
        for (size_t i = 0; i < std::min(SHOWN, s.categories.size()); ++i)
            probabilities.push_back({printable(s.categories[i].name), s.categories[i].probability});
        json axes = json::array();
        for (const auto& axis : box.axes.axes()) axes.push_back(list(axis));
        all.push_back(
            {{"id", s.id},
             {"category", printable(s.category())},
             {"probability", s.probability()},
             {"probabilities", probabilities},
             {"entropy", s.entropy},
             {"doubt", s.geometricEntropy},
             {"observations", s.observations},
             {"voxels", s.voxels},
             {"at", list(s.centroid)},
             {"centroid", list(map.inMap(s.centroid))},
             {"box",
              {{"center", list(map.inMap(box.center))}, {"size", list(box.size)}, {"axes", axes}}},
             {"color", hex(colors.at(s.id))},
             {"categoryColor", hex(categoryPalette.at(s.category()))}});
    }
    return all;
}

/** One scale for both uncertainties: the largest of an instance or, but for strays, of a voxel. */
double scaleOf(const std::vector<FoundInstance>& instances, std::vector<double> doubts)
{
    constexpr double LEAST = 0.05, STRAYS = 0.01;
    double scale = LEAST;
    for (const FoundInstance& f : instances) scale = std::max(scale, f.summary.entropy);
    if (doubts.empty()) return scale;
    const auto n = static_cast<long>((1 - STRAYS) * static_cast<double>(doubts.size() - 1));
    std::nth_element(doubts.begin(), doubts.begin() + n, doubts.end());
    return std::max(scale, doubts[static_cast<size_t>(n)]);
}

/** Adds everything that has to do with single voxels. */
void addVoxels(const SemanticVoxelMap& map, const std::vector<FoundInstance>& instances, json& data)
{
    std::map<instance_id_t, uint32_t> owners = {{UNKNOWN_INSTANCE, 0}};
    for (const FoundInstance& f : instances)
        owners.emplace(f.summary.id, static_cast<uint32_t>(owners.size()));
    constexpr int32_t MOST = std::numeric_limits<int32_t>::max();
    std::array<int32_t, 3> low = {MOST, MOST, MOST};
    std::vector<std::array<int32_t, 3>> voxels;
    std::vector<double> doubts;
    std::vector<uint8_t> positionBytes, ownerBytes, doubtBytes;
    const VoxelUncertainty uncertainty(map);
    map.forEachVoxel([&](const VoxelCoord& v, log_odds_t, const VoxelEvidence& evidence) {
        voxels.push_back({v.x, v.y, v.z});
        for (size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], voxels.back()[a]);
        append(ownerBytes, owners.at(map.winner(evidence)));
        doubts.push_back(uncertainty.instanceEntropy(evidence));
    });
    for (const auto& v : voxels)
        for (size_t a = 0; a < 3; ++a) {
            if (v[a] - low[a] > std::numeric_limits<uint16_t>::max())
                throw ConfigurationError(
                    "the map is wider than the 65536 voxels that a report can "
                    "show: use a coarser resolution");
            append(positionBytes, static_cast<uint16_t>(v[a] - low[a]));
        }
    const double scale = scaleOf(instances, doubts);
    for (const double d : doubts)
        doubtBytes.push_back(static_cast<uint8_t>(std::lround(255 * std::min(1.0, d / scale))));
    data["voxels"] = voxels.size();
    data["origin"] = voxels.empty() ? json{0, 0, 0} : json(low);
    data["positions"] = base64(positionBytes);
    data["owners"] = base64(ownerBytes);
    data["doubts"] = base64(doubtBytes);
    data["scale"] = scale;
}
}  // namespace

std::string reportData(const SemanticVoxelMap& map, const MappingCounts& counts,
                       const ReportOptions& options)
{
    ViewOptions viewOptions;
    viewOptions.up = options.up ? *options.up : estimateUp(map);
    viewOptions.height = 800;
    const MapViews views = drawViews(map, viewOptions);
    const GravityAlignedFrame frame(*viewOptions.up);
    const std::vector<FoundInstance> instances = listInstances(map, frame);
    json data = {{"title", options.title},           {"timing", options.timing},
                 {"evaluation", options.evaluation}, {"summary", summaryOf(map, counts)},
                 {"resolution", map.resolution()},   {"azimuth", views.azimuth},
                 {"unknown", hex(UNKNOWN_COLOR)},    {"instances", instancesOf(map, instances)}};
    for (const auto& axis : frame.axes()) data["axes"].push_back(list(axis));
    constexpr int TONES = 64;
    for (int i = 0; i < TONES; ++i)
        data["ramp"].push_back(hex(uncertaintyColor(i / static_cast<double>(TONES - 1))));
    addVoxels(map, instances, data);
    for (const MapViews::Picture& picture : views.pictures)
        data["pictures"].push_back({{"title", picture.title}, {"png", base64(picture.png)}});
    return data.dump(-1, ' ', false, json::error_handler_t::replace);
}
}  // namespace voxeland
