// SPDX-License-Identifier: BSD-3-Clause
#include "MapPly.h"

#include "files/LittleEndianStream.h"
#include "pictures/Colors.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/map/MapQueries.h"

#include <algorithm>
#include <cctype>

namespace voxeland
{
namespace
{
/** A name on one line: a comment ends where the line does. */
std::string onOneLine(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return name;
}

/** Whether coordinates need more digits than a float has. */
bool isFar(const SemanticVoxelMap& map)
{
    return map.origin() != mrpt::math::TPoint3D();
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
    for (const char* name : {"x", "y", "z"})
        out << (isFar(map) ? "property double " : "property float ") << name << "\n";
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

/** Writes some of a map's voxels at a time. */
class PlyWriter
{
 public:
    explicit PlyWriter(const SemanticVoxelMap& map)
        : m_map(map),
          m_categories(topCategories(map)),
          m_colors(instanceColors(map)),
          m_uncertainty(map)
    {
    }

    void write(const std::vector<VoxelCoord>& voxels, const std::string& file)
    {
        writeAtomically(file, [&](std::ostream& out) {
            writeHeader(m_map, voxels.size(), out);
            LittleEndianStream body(out);
            for (const VoxelCoord& v : voxels) writeVertex(v, body);
        });
    }
    void writeAll(const std::string& file, bool occupiedOnly)
    {
        size_t voxels = 0;
        m_map.forEachVoxel([&](const auto&...) { ++voxels; }, occupiedOnly);
        writeAtomically(file, [&](std::ostream& out) {
            writeHeader(m_map, voxels, out);
            LittleEndianStream body(out);
            m_map.forEachVoxel([&](const VoxelCoord& v, const auto&...) { writeVertex(v, body); },
                               occupiedOnly);
        });
    }

 private:
    void writeVertex(const VoxelCoord& v, LittleEndianStream& body)
    {
        const VoxelEvidence& evidence = *m_map.evidence(v);
        const auto at = m_map.inWorld(voxelCenter<mrpt::math::TPoint3D>(v, m_map.resolution()));
        for (const double x : {at.x, at.y, at.z})
            if (isFar(m_map))
                body << x;
            else
                body << static_cast<float>(x);
        const instance_id_t id = m_map.winner(evidence);
        const Color& color = m_colors.at(id);
        body << color.red << color.green << color.blue << static_cast<int32_t>(id);
        const auto category = m_categories.find(id);
        body << (category == m_categories.end() ? int32_t{-1} : category->second);
        for (const double x : {OccupancyFilter::probability(m_map.occupancy(v)),
                               m_uncertainty.instanceEntropy(evidence),
                               m_uncertainty.winnerCategoryEntropy(evidence),
                               m_uncertainty.categoryEntropy(evidence)})
            body << static_cast<float>(x);
    }

    const SemanticVoxelMap& m_map;
    std::map<instance_id_t, int32_t> m_categories;
    std::map<instance_id_t, Color> m_colors;
    VoxelUncertainty m_uncertainty;
};

/** "12_dining_table": letters and digits of the category, so that any file system takes it, and
 * not too many of them. */
std::string fileNameOf(instance_id_t id, const std::string& category)
{
    constexpr size_t LONGEST = 60;
    std::string name = category.substr(0, LONGEST);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; },
        '_');
    return std::to_string(id) + "_" + name + ".ply";
}
}  // namespace

void exportPly(const SemanticVoxelMap& map, const std::string& file, bool occupiedOnly)
{
    PlyWriter(map).writeAll(file, occupiedOnly);
}

void exportPlyPerInstance(const SemanticVoxelMap& map, const std::string& folder,
                          WrittenFiles& written, bool occupiedOnly)
{
    makeOutputFolder(folder);
    const auto categories = topCategories(map);
    PlyWriter writer(map);
    for (const auto& [id, voxels] : voxelsByWinner(map, occupiedOnly)) {
        const auto category = categories.find(id);
        const bool none = category == categories.end();
        const std::string name =
            none ? UNKNOWN_CATEGORY
                 : map.categories().name(static_cast<category_id_t>(category->second));
        const std::string file = folder + "/" + fileNameOf(id, name);
        writer.write(voxels, file);
        written.add(file);
    }
}

Exporter plyExporter()
{
    Exporter e{
        "ply", "FILE",
        "Voxels as a binary point cloud with instance, category, occupancy and uncertainties"};
    e.endings = {".ply"};
    e.nameInAll = "map.ply";
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportPly(map, file, settings.occupiedOnly);
        written.add(file);
    };
    return e;
}

Exporter plyPerInstanceExporter()
{
    Exporter e{"per-instance", "DIR", "Folder for a PLY of each instance"};
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& folder, WrittenFiles& written) {
        exportPlyPerInstance(map, folder, written, settings.occupiedOnly);
    };
    return e;
}
}  // namespace voxeland
