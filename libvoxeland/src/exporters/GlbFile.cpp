// SPDX-License-Identifier: BSD-3-Clause
#include "GlbFile.h"

#include "JsonValues.h"
#include "files/LittleEndianStream.h"
#include "grid/MergedFaces.h"
#include "grid/VoxelFaces.h"
#include "pictures/Colors.h"
#include "voxeland/base/errors.h"
#include "voxeland/files/AtomicFile.h"

#include <cmath>

namespace voxeland
{
namespace
{
// Numbers that the glTF 2.0 specification gives its constants.
constexpr int FLOAT = 5126, UNSIGNED_INT = 5125, ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963,
              TRIANGLES = 4;
constexpr size_t VERTEX_BYTES = 12;         //!< of a position or a normal: three floats
constexpr size_t CORNERS = 4, INDICES = 6;  //!< of a face, as two triangles

using Corner = std::array<float, 3>;

/** The corners of a face [m], counter-clockwise as seen from outside. */
std::array<Corner, CORNERS> cornersOf(const FaceRectangle& face, double resolution)
{
    const size_t axis = face.side / 2;
    const bool positive = face.side % 2 == 1;
    const size_t first = (axis + (positive ? 1 : 2)) % 3, second = (axis + (positive ? 2 : 1)) % 3;
    std::array<Corner, CORNERS> corners{};
    for (size_t i = 0; i < CORNERS; ++i) {
        std::array<int32_t, 3> at = face.low;
        at[axis] += positive ? 1 : 0;
        at[first] += i == 1 || i == 2 ? face.size[first] : 0;
        at[second] += i >= 2 ? face.size[second] : 0;
        for (size_t a = 0; a < 3; ++a) corners[i][a] = static_cast<float>(at[a] * resolution);
    }
    return corners;
}

/** One node of the file: an instance, or what belongs to none. */
struct Part
{
    std::string name;
    json_t extras;
    Color color;
    std::vector<FaceRectangle> faces;
};

/** The faces of an instance's voxels that no other one of them covers. */
std::vector<FaceRectangle> outerFaces(const SemanticVoxelMap& map, instance_id_t id,
                                      const std::vector<VoxelCoord>& voxels)
{
    return mergedFaces(voxels, [&](const VoxelCoord& v) {
        const VoxelEvidence* evidence = map.evidence(v);
        return evidence != nullptr && OccupancyFilter::isOccupied(map.occupancy(v)) &&
               map.winner(*evidence) == id;
    });
}

std::vector<Part> partsOf(const SemanticVoxelMap& map)
{
    const auto voxels = voxelsByWinner(map);
    std::vector<Part> parts;
    const auto colors = instanceColors(map);
    for (const InstanceSummary& s : summarizeInstances(map))
        parts.push_back({s.category() + " " + std::to_string(s.id),
                         {{"id", s.id},
                          {"category", s.category()},
                          {"probability", s.probability()},
                          {"entropy", s.entropy}},
                         colors.at(s.id),
                         outerFaces(map, s.id, voxels.at(s.id))});
    if (const auto rest = voxels.find(UNKNOWN_INSTANCE); rest != voxels.end())
        parts.push_back({UNKNOWN_CATEGORY,
                         {{"id", UNKNOWN_INSTANCE}},
                         UNKNOWN_COLOR,
                         outerFaces(map, rest->first, rest->second)});
    return parts;
}

/** A colour's channel as light is added, in [0,1]: glTF wants it so (the sRGB transfer function).
 */
double linear(uint8_t channel)
{
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/** From the map's frame to the world's about it, turned until its y axis is up; column by column.
 * The map's place is here, and not in its vertices, as these are floats. \param origin of the map's
 * frame [m] */
json_t rootMatrix(const GravityAlignedFrame& frame, const mrpt::math::TPoint3D& origin)
{
    json_t matrix = json_t::array();
    for (size_t column = 0; column < 3; ++column) {
        const auto& [x, y, z] = frame.axes();
        for (const double value : {x[column], z[column], -y[column], 0.0}) matrix.push_back(value);
    }
    for (const double value : {origin.x, origin.z, 0 - origin.y, 1.0}) matrix.push_back(value);
    return matrix;
}

/** Builds the JSON chunk, and keeps count of the bytes that follow it. */
class Document
{
 public:
    Document(const SemanticVoxelMap& map, const GravityAlignedFrame& frame)
        : m_resolution(map.resolution())
    {
        m_json = {
            {"asset", {{"version", "2.0"}, {"generator", "Voxeland for MRPT"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"name", "voxeland map"}, {"matrix", rootMatrix(frame, map.origin())}}}}};
    }

    void add(const Part& part)
    {
        const size_t vertices = part.faces.size() * CORNERS;
        const size_t positions = addAccessor(vertices * VERTEX_BYTES, ARRAY_BUFFER,
                                             {{"componentType", FLOAT},
                                              {"count", vertices},
                                              {"type", "VEC3"},
                                              {"min", extreme(part, false)},
                                              {"max", extreme(part, true)}});
        const size_t normals =
            addAccessor(vertices * VERTEX_BYTES, ARRAY_BUFFER,
                        {{"componentType", FLOAT}, {"count", vertices}, {"type", "VEC3"}});
        const size_t count = part.faces.size() * INDICES;
        const size_t indices =
            addAccessor(count * sizeof(uint32_t), ELEMENT_ARRAY_BUFFER,
                        {{"componentType", UNSIGNED_INT}, {"count", count}, {"type", "SCALAR"}});
        const size_t number = m_json["nodes"].size() - 1;
        m_json["materials"].push_back(
            {{"name", part.name},
             {"pbrMetallicRoughness",
              {{"baseColorFactor",
                {linear(part.color.red), linear(part.color.green), linear(part.color.blue), 1}},
               {"metallicFactor", 0},
               {"roughnessFactor", 1}}}});
        m_json["meshes"].push_back(
            {{"name", part.name},
             {"primitives",
              {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                {"indices", indices},
                {"material", number},
                {"mode", TRIANGLES}}}}});
        m_json["nodes"].push_back({{"name", part.name}, {"mesh", number}, {"extras", part.extras}});
        m_json["nodes"][0]["children"].push_back(number + 1);
    }

    /** The chunk's text, padded with spaces to whole words. */
    [[nodiscard]] std::string text()
    {
        if (m_bytes > 0) m_json["buffers"] = {{{"byteLength", m_bytes}}};
        std::string text = m_json.dump(-1, ' ', false, json_t::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return text;
    }
    [[nodiscard]] size_t bytes() const { return m_bytes; }

 private:
    /** \return number of the accessor of the next `bytes` bytes */
    size_t addAccessor(size_t bytes, int target, json_t accessor)
    {
        const size_t number = m_json["accessors"].size();
        accessor["bufferView"] = number;
        m_json["accessors"].push_back(std::move(accessor));
        m_json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", m_bytes}, {"byteLength", bytes}, {"target", target}});
        m_bytes += bytes;
        return number;
    }

    /** Least or greatest coordinates of a part's corners. */
    [[nodiscard]] json_t extreme(const Part& part, bool greatest) const
    {
        Corner result = cornersOf(part.faces.front(), m_resolution)[0];
        for (const FaceRectangle& face : part.faces)
            for (const Corner& corner : cornersOf(face, m_resolution))
                for (size_t a = 0; a < 3; ++a)
                    result[a] =
                        greatest ? std::max(result[a], corner[a]) : std::min(result[a], corner[a]);
        return result;
    }

    double m_resolution;
    json_t m_json;
    size_t m_bytes = 0;
};

void writeBuffer(const Part& part, double resolution, LittleEndianStream& out)
{
    for (const FaceRectangle& face : part.faces)
        for (const Corner& corner : cornersOf(face, resolution))
            for (const float x : corner) out << x;
    for (const FaceRectangle& face : part.faces)
        for (size_t i = 0; i < CORNERS; ++i) {
            const VoxelCoord& n = FACES[face.side];
            out << static_cast<float>(n.x) << static_cast<float>(n.y) << static_cast<float>(n.z);
        }
    for (uint32_t first = 0; first < part.faces.size() * CORNERS; first += CORNERS)
        for (const uint32_t i : {0, 1, 2, 0, 2, 3}) out << first + i;
}
}  // namespace

void exportGlb(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
               const std::string& file)
{
    const std::vector<Part> parts = partsOf(map);
    Document document(map, frame);
    for (const Part& part : parts) document.add(part);
    const std::string text = document.text();
    constexpr size_t HEADER = 12, CHUNK_HEADER = 8;
    const size_t length =
        HEADER + CHUNK_HEADER + text.size() + (parts.empty() ? 0 : CHUNK_HEADER + document.bytes());
    if (length > UINT32_MAX)
        throw ConfigurationError(
            "the mesh would not fit into a glTF file of 4 GB: use a coarser "
            "resolution");
    writeAtomically(file, [&](std::ostream& stream) {
        constexpr uint32_t MAGIC = 0x46546C67, VERSION = 2, JSON = 0x4E4F534A, BIN = 0x004E4942;
        LittleEndianStream out(stream);
        out << MAGIC << VERSION << static_cast<uint32_t>(length);
        out << static_cast<uint32_t>(text.size()) << JSON;
        stream << text;
        if (parts.empty()) return;
        out << static_cast<uint32_t>(document.bytes()) << BIN;
        for (const Part& part : parts) writeBuffer(part, map.resolution(), out);
    });
}

Exporter glbExporter()
{
    Exporter e{"glb", "FILE.glb",
               "Binary glTF: voxels as a coloured mesh, a node for each instance"};
    e.endings = {".glb"};
    e.write = [](const SemanticVoxelMap& map, const ExportSettings& settings,
                 const std::string& file, WrittenFiles& written) {
        exportGlb(map, settings.frame, file);
        written.add(file);
    };
    return e;
}
}  // namespace voxeland
