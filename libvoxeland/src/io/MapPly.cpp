// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/MapPly.h"

#include "voxeland/io/AtomicFile.h"
#include "voxeland/io/Colors.h"
#include "voxeland/map/MapQueries.h"

#include <mrpt/core/reverse_bytes.h>

#include <algorithm>

namespace voxeland
{
namespace
{
/** Writes numbers little-endian, whatever the machine. */
class LittleEndianStream
{
 public:
    explicit LittleEndianStream(std::ostream& out) : m_out(out) {}
    template <typename T>
    LittleEndianStream& operator<<(T value)
    {
        value = mrpt::toNativeEndianness(value);
        m_out.write(reinterpret_cast<const char*>(&value), sizeof(value));
        return *this;
    }

 private:
    std::ostream& m_out;
};

/** A name on one line: a comment ends where the line does. */
std::string onOneLine(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return name;
}

void writeHeader(const SemanticVoxelMap& map, size_t voxels, std::ostream& out)
{
    out << "ply\nformat binary_little_endian 1.0\n"
        << "comment voxels of a Voxeland map, metres, nats\n"
        << "comment resolution " << map.resolution() << "\n"
        << "comment entropy " << toString(map.options().entropy) << "\n";
    for (category_id_t c = 0; c < map.categories().size(); ++c)
        out << "comment category " << c << " " << onOneLine(map.categories().name(c)) << "\n";
    out << "element vertex " << voxels << "\n";
    for (const char* name : {"x", "y", "z"}) out << "property float " << name << "\n";
    for (const char* name : {"red", "green", "blue"}) out << "property uchar " << name << "\n";
    for (const char* name : {"instanceid", "categoryid"}) out << "property int " << name << "\n";
    for (const char* name :
         {"occupancy", "uncertainty_instances", "uncertainty_categories", "uncertainty_semantic"})
        out << "property float " << name << "\n";
    out << "end_header\n";
}

/** Most probable category of every instance. */
std::map<instance_id_t, int32_t> topCategories(const SemanticVoxelMap& map)
{
    std::map<instance_id_t, int32_t> top;
    for (const auto& [id, instance] : map.instances()) {
        const auto ranked = categoryDistribution(map, instance);
        if (!ranked.empty()) top[id] = static_cast<int32_t>(ranked.front().category);
    }
    return top;
}
}  // namespace

void exportPly(const SemanticVoxelMap& map, const std::string& file, bool occupiedOnly)
{
    size_t voxels = 0;
    map.forEachVoxel([&](const auto&...) { ++voxels; }, occupiedOnly);
    const auto categories = topCategories(map);
    VoxelUncertainty uncertainty(map);

    writeAtomically(file, [&](std::ostream& out) {
        writeHeader(map, voxels, out);
        LittleEndianStream body(out);
        map.forEachVoxel(
            [&](const VoxelCoord& v, log_odds_t occupancy, const VoxelEvidence& evidence) {
                const auto at = voxelCenter<mrpt::math::TPoint3D>(v, map.resolution());
                for (const double x : {at.x, at.y, at.z}) body << static_cast<float>(x);
                const instance_id_t id = evidence.winner();
                const Color color = instanceColor(id);
                body << color.red << color.green << color.blue << static_cast<int32_t>(id);
                const auto category = categories.find(id);
                body << (category == categories.end() ? int32_t{-1} : category->second);
                for (const double x : {OccupancyFilter::probability(occupancy),
                                       uncertainty.instanceEntropy(evidence),
                                       uncertainty.winnerCategoryEntropy(evidence),
                                       uncertainty.categoryEntropy(evidence)})
                    body << static_cast<float>(x);
            },
            occupiedOnly);
    });
}
}  // namespace voxeland
