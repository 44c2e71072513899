// SPDX-License-Identifier: BSD-3-Clause
/** Files read back by the rules of the glTF 2.0 specification, with nothing of the writer's. */
#include "exporters/GlbFile.h"
#include "pictures/Colors.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

using namespace voxeland;
using nlohmann::json;
using voxeland::test::TemporaryFolder;

namespace
{
using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** A binary glTF file as its two chunks. */
struct Glb
{
    explicit Glb(const std::string& bytes)
    {
        const auto word = [&](size_t at) {
            uint32_t value = 0;
            std::memcpy(&value, bytes.data() + at, sizeof(value));
            return value;
        };
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(word(4), 2U);
        EXPECT_EQ(word(8), bytes.size());
        const uint32_t length = word(12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        EXPECT_EQ(length % 4, 0U);
        document = json::parse(bytes.substr(20, length));
        EXPECT_EQ(document["asset"]["version"], "2.0");
        if (20 + length == bytes.size()) return;
        EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
        buffer = bytes.substr(28 + length);
        EXPECT_EQ(word(20 + length), buffer.size());
        EXPECT_EQ(document["buffers"][0]["byteLength"], buffer.size());
    }

    /** Elements of an accessor: 1 or 3 numbers each. */
    template <typename T>
    [[nodiscard]] std::vector<T> elements(size_t accessor, int componentType) const
    {
        const json& a = document["accessors"][accessor];
        const json& view = document["bufferViews"][a["bufferView"].get<size_t>()];
        EXPECT_EQ(a["componentType"], componentType);
        const size_t count = a["count"].get<size_t>() * (a["type"] == "VEC3" ? 3 : 1);
        const size_t offset = view["byteOffset"];
        EXPECT_EQ(offset % sizeof(T), 0U);
        EXPECT_EQ(view["byteLength"], count * sizeof(T));
        std::vector<T> values(count);
        std::memcpy(values.data(), buffer.data() + offset, count * sizeof(T));
        return values;
    }

    json document;
    std::string buffer;
};

/** One node's mesh, measured. */
struct Solid
{
    double area = 0;    //!< [m^2]
    double volume = 0;  //!< enclosed, by the divergence theorem [m^3]
    size_t triangles = 0;
    bool normalsFit = true;
};

Solid measure(const Glb& glb, const json& node)
{
    const json& primitive = glb.document["meshes"][node["mesh"].get<size_t>()]["primitives"][0];
    EXPECT_EQ(primitive["mode"], 4);
    const size_t position = primitive["attributes"]["POSITION"];
    const auto points = glb.elements<float>(position, 5126);
    const auto normals = glb.elements<float>(primitive["attributes"]["NORMAL"], 5126);
    const auto indices = glb.elements<uint32_t>(primitive["indices"], 5125);
    const auto vertex = [](const std::vector<float>& values, uint32_t i) {
        return Vector{values.at(3 * i), values.at(3 * i + 1), values.at(3 * i + 2)};
    };
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_GE(points[i], glb.document["accessors"][position]["min"][i % 3].get<float>());
        EXPECT_LE(points[i], glb.document["accessors"][position]["max"][i % 3].get<float>());
    }
    Solid solid;
    for (size_t i = 0; i < indices.size(); i += 3) {
        const Vector a = vertex(points, indices[i]), b = vertex(points, indices[i + 1]),
                     c = vertex(points, indices[i + 2]);
        const Vector twice = cross(minus(b, a), minus(c, a));
        const double area = std::sqrt(dot(twice, twice)) / 2;
        solid.area += area;
        solid.volume += dot(a, cross(b, c)) / 6;
        ++solid.triangles;
        if (dot(twice, vertex(normals, indices[i])) < 1.99 * area) solid.normalsFit = false;
    }
    return solid;
}

Glb exported(const SemanticVoxelMap& map, const GravityAlignedFrame& frame = GravityAlignedFrame())
{
    const TemporaryFolder folder;
    exportGlb(map, frame, folder.file("m.glb"));
    return Glb(test::readFile(folder.file("m.glb")));
}

/** An instance of 2 x 2 x 2 voxels of 0.1 m beside another of one voxel. */
SemanticVoxelMap twoBlocks()
{
    SemanticVoxelMap map = test::emptyMap();
    const auto box = test::addInstance(map, {{"box", 1}}),
               cup = test::addInstance(map, {{"cup", 3}});
    for (int i = 0; i < 8; ++i) test::addVoxel(map, {i & 1, i >> 1 & 1, 5 + (i >> 2)}, {{box, 1}});
    test::addVoxel(map, {2, 0, 5}, {{cup, 1}});
    return map;
}
}  // namespace

/** Area of a cube of 0.2 m: 0.24 m^2; its volume, positive as the faces look outwards: 0.008. */
TEST(GlbFile, eachInstanceIsAClosedMeshOfItsOuterFaces)
{
    const Glb glb = exported(twoBlocks());
    const json& nodes = glb.document["nodes"];
    ASSERT_EQ(nodes.size(), 3U);
    EXPECT_EQ(nodes[0]["children"], (json{1, 2}));
    EXPECT_EQ(glb.document["scenes"][0]["nodes"], json{0});
    EXPECT_EQ(nodes[1]["name"], "box 1");
    EXPECT_EQ(nodes[2]["name"], "cup 2");
    EXPECT_EQ(nodes[2]["extras"]["category"], "cup");
    EXPECT_EQ(nodes[2]["extras"]["probability"], 1);
    const Solid box = measure(glb, nodes[1]), cup = measure(glb, nodes[2]);
    EXPECT_NEAR(box.area, 0.24, 1e-6);
    EXPECT_NEAR(box.volume, 0.008, 1e-6);
    EXPECT_EQ(box.triangles, 12U) << "four faces of a side are one rectangle";
    EXPECT_TRUE(box.normalsFit);
    EXPECT_NEAR(cup.area, 0.06, 1e-6);
    EXPECT_NEAR(cup.volume, 0.001, 1e-6);
    EXPECT_TRUE(cup.normalsFit);
}

/** Of a random heap: each face that no other voxel of the instance covers is there, once. */
TEST(GlbFile, facesSideBySideAreMergedAndNoneIsLost)
{
    SemanticVoxelMap map = test::emptyMap();
    const auto heap = test::addInstance(map, {{"heap", 1}}),
               hole = test::addInstance(map, {{"hole", 1}});
    std::set<std::array<int, 3>> there;
    std::mt19937 random(5);
    for (int x = -5; x < 5; ++x)
        for (int y = -5; y < 5; ++y)
            for (int z = -5; z < 5; ++z) {
                const bool isHeap = random() % 4 != 0;
                test::addVoxel(map, {x, y, z}, {{isHeap ? heap : hole, 1}});
                if (isHeap) there.insert({x, y, z});
            }
    size_t faces = 0;
    for (const auto& [x, y, z] : there)
        for (const auto& n :
             {std::array{x - 1, y, z}, std::array{x + 1, y, z}, std::array{x, y - 1, z},
              std::array{x, y + 1, z}, std::array{x, y, z - 1}, std::array{x, y, z + 1}})
            faces += there.count(n) == 0 ? 1 : 0;
    const Glb glb = exported(map);
    const Solid solid = measure(glb, glb.document["nodes"][1]);
    EXPECT_NEAR(solid.area, 0.01 * static_cast<double>(faces), 1e-4);
    EXPECT_NEAR(solid.volume, 0.001 * static_cast<double>(there.size()), 1e-5);
    EXPECT_TRUE(solid.normalsFit);
    EXPECT_LT(solid.triangles, 2 * faces * 3 / 4);
}

TEST(GlbFile, materialsHaveTheColoursOfInstances)
{
    const SemanticVoxelMap map = twoBlocks();
    const Glb glb = exported(map);
    const auto colors = instanceColors(map);
    for (const size_t node : {1, 2}) {
        const size_t mesh = glb.document["nodes"][node]["mesh"];
        const size_t material = glb.document["meshes"][mesh]["primitives"][0]["material"];
        const json& factor =
            glb.document["materials"][material]["pbrMetallicRoughness"]["baseColorFactor"];
        const double red = colors.at(static_cast<instance_id_t>(node)).red / 255.0;
        EXPECT_NEAR(factor[0].get<double>(), std::pow(red, 2.2), 0.02) << "about linear";
        EXPECT_EQ(factor[3], 1);
    }
}

/** glTF's y axis is up, and what is ahead of a camera (its -z) is away from the viewer. */
TEST(GlbFile, theRootTurnsUpToY)
{
    const auto turned = [](const GravityAlignedFrame& frame, const Vector& p) {
        const json m = exported(twoBlocks(), frame).document["nodes"][0]["matrix"];
        Vector result{};
        for (size_t row = 0; row < 3; ++row)
            for (size_t column = 0; column < 3; ++column)
                result[row] += m[4 * column + row].get<double>() * p[column];
        return result;
    };
    EXPECT_EQ(turned(GravityAlignedFrame(), {1, 2, 3}), (Vector{1, 3, -2}));
    EXPECT_EQ(turned(GravityAlignedFrame({0, -1, 0}), {1, 2, 3}), (Vector{1, -2, -3}));
}

TEST(GlbFile, whatBelongsToNoneIsUnknown)
{
    const Glb glb = exported(test::tinyMap());
    EXPECT_EQ(glb.document["nodes"][3]["name"], "unknown");
    EXPECT_NEAR(measure(glb, glb.document["nodes"][3]).volume, 0.001, 1e-6);
}

TEST(GlbFile, emptyMapsAndUnwritableFiles)
{
    const Glb glb = exported(SemanticVoxelMap());
    EXPECT_FALSE(glb.document.contains("buffers"));
    EXPECT_FALSE(glb.document.contains("meshes"));
    EXPECT_THROW(exportGlb(twoBlocks(), GravityAlignedFrame(), "/no/such/folder/m.glb"),
                 OutputError);
}
