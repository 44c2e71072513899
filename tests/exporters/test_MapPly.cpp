// SPDX-License-Identifier: BSD-3-Clause
#include "exporters/MapPly.h"
#include "pictures/Colors.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <sstream>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
using voxeland::test::tinyMap;

namespace
{
/** A PLY file as any reader sees it: header lines, and one number per property and vertex. */
struct Ply
{
    std::vector<std::string> comments;
    std::vector<std::pair<std::string, std::string>> properties;  //!< type, name
    std::vector<std::map<std::string, double>> vertices;
    size_t bytesLeft = 0;
};

/** Little-endian bytes as a number. */
double number(const std::string& type, const uint8_t* bytes)
{
    if (type == "uchar") return bytes[0];
    const uint32_t word = static_cast<uint32_t>(bytes[0]) | static_cast<uint32_t>(bytes[1]) << 8 |
                          static_cast<uint32_t>(bytes[2]) << 16 |
                          static_cast<uint32_t>(bytes[3]) << 24;
    if (type == "int") return static_cast<int32_t>(word);
    float value = 0;
    std::memcpy(&value, &word, sizeof(value));
    return static_cast<double>(value);
}

Ply parse(const std::string& content)
{
    Ply ply;
    std::istringstream header(content);
    std::string line;
    size_t vertices = 0;
    std::getline(header, line);
    EXPECT_EQ(line, "ply");
    std::getline(header, line);
    EXPECT_EQ(line, "format binary_little_endian 1.0");
    while (std::getline(header, line) && line != "end_header") {
        std::istringstream words(line);
        std::string first, type, name;
        words >> first;
        if (first == "comment") ply.comments.push_back(line.substr(8));
        if (first == "element") words >> name >> vertices;
        if (first == "property" && words >> type >> name) ply.properties.emplace_back(type, name);
    }
    auto at = static_cast<size_t>(header.tellg());
    for (size_t i = 0; i < vertices; ++i) {
        auto& vertex = ply.vertices.emplace_back();
        for (const auto& [type, name] : ply.properties) {
            uint8_t bytes[4] = {};
            const size_t size = type == "uchar" ? 1 : 4;
            content.copy(reinterpret_cast<char*>(bytes), size, at);
            vertex[name] = number(type, bytes);
            at += size;
        }
    }
    ply.bytesLeft = content.size() - at;
    return ply;
}

Ply exported(const SemanticVoxelMap& map, bool occupiedOnly = true)
{
    const TemporaryFolder folder;
    exportPly(map, folder.file("map.ply"), occupiedOnly);
    return parse(test::readFile(folder.file("map.ply")));
}

/** The vertex at a voxel of the tiny map. */
std::map<std::string, double> at(const Ply& ply, const VoxelCoord& v)
{
    for (const auto& p : ply.vertices)
        if (std::abs(p.at("x") - (v.x + 0.5) * test::TINY_RESOLUTION) < 1e-6 &&
            std::abs(p.at("y") - (v.y + 0.5) * test::TINY_RESOLUTION) < 1e-6 &&
            std::abs(p.at("z") - (v.z + 0.5) * test::TINY_RESOLUTION) < 1e-6)
            return p;
    throw std::runtime_error("no such vertex");
}
}  // namespace

TEST(MapPly, hasThePropertiesOthersExpect)
{
    const Ply ply = exported(tinyMap());
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"float", "x"},
        {"float", "y"},
        {"float", "z"},
        {"uchar", "red"},
        {"uchar", "green"},
        {"uchar", "blue"},
        {"int", "instanceid"},
        {"int", "categoryid"},
        {"float", "occupancy"},
        {"float", "uncertainty_instances"},
        {"float", "uncertainty_categories"},
        {"float", "uncertainty_semantic"}};
    EXPECT_EQ(ply.properties, expected);
    EXPECT_EQ(ply.bytesLeft, 0U);
    for (const char* c : {"category 0 chair", "category 1 table", "category 2 cup"})
        EXPECT_EQ(std::count(ply.comments.begin(), ply.comments.end(), c), 1) << c;
}

TEST(MapPly, everyVoxelWithItsNumbers)
{
    const Ply ply = exported(tinyMap());
    ASSERT_EQ(ply.vertices.size(), 3U);
    constexpr double TOLERANCE = 1e-6;

    const auto seat = at(ply, {0, 0, 0});
    EXPECT_EQ(seat.at("instanceid"), 1);
    EXPECT_EQ(seat.at("categoryid"), 0) << "of equals, chair comes first";
    EXPECT_NEAR(seat.at("occupancy"), 0.9, 1e-3);
    EXPECT_NEAR(seat.at("uncertainty_instances"), test::H_INSTANCE_10_1, TOLERANCE);
    EXPECT_NEAR(seat.at("uncertainty_categories"), test::H_CATEGORY_2_2, TOLERANCE);
    EXPECT_NEAR(seat.at("uncertainty_semantic"), test::H_SEMANTIC_SEAT, TOLERANCE);
    EXPECT_EQ(seat.at("red"), instanceColors(tinyMap()).at(1).red);
    EXPECT_EQ(seat.at("green"), instanceColors(tinyMap()).at(1).green);
    EXPECT_EQ(seat.at("blue"), instanceColors(tinyMap()).at(1).blue);

    const auto cup = at(ply, {1, 0, 0});
    EXPECT_EQ(cup.at("instanceid"), 2);
    EXPECT_EQ(cup.at("categoryid"), 2);
    EXPECT_NEAR(cup.at("uncertainty_instances"), test::H_INSTANCE_1_1, TOLERANCE);
    EXPECT_EQ(cup.at("uncertainty_categories"), 0);
    EXPECT_NEAR(cup.at("uncertainty_semantic"), test::H_SEMANTIC_CUP, TOLERANCE);

    const auto unknown = at(ply, {-1, -1, -1});
    EXPECT_EQ(unknown.at("instanceid"), 0);
    EXPECT_EQ(unknown.at("categoryid"), -1);
    EXPECT_EQ(unknown.at("uncertainty_instances"), 0);
    EXPECT_EQ(unknown.at("uncertainty_semantic"), 0);
    EXPECT_EQ(unknown.at("red"), UNKNOWN_COLOR.red);
}

TEST(MapPly, freeVoxelsOnlyWhenAskedFor)
{
    const Ply ply = exported(tinyMap(), false);
    ASSERT_EQ(ply.vertices.size(), 4U);
    EXPECT_NEAR(at(ply, {5, 5, 5}).at("occupancy"), 0.2, 1e-3);
    EXPECT_EQ(at(ply, {5, 5, 5}).at("instanceid"), 2);
}

TEST(MapPly, anEmptyMapIsAnEmptyCloud)
{
    const Ply ply = exported(SemanticVoxelMap());
    EXPECT_EQ(ply.properties.size(), 12U);
    EXPECT_TRUE(ply.vertices.empty());
}

TEST(MapPly, aNameWithALineBreakDoesNotBreakTheHeader)
{
    SemanticVoxelMap map = tinyMap();
    map.categories().add("two\nend_header");
    EXPECT_EQ(exported(map).vertices.size(), 3U);
}

TEST(MapPly, oneFileAnInstance)
{
    const TemporaryFolder folder;
    SemanticVoxelMap map = tinyMap();
    const auto desk = test::addInstance(map, {{"dining table/../", 1}});
    test::addVoxel(map, {7, 7, 7}, {{desk, 1}});
    WrittenFiles written;
    exportPlyPerInstance(map, folder.file("all"), written);
    const auto& files = written.names();
    std::vector<std::string> expected;
    for (const char* name : {"0_unknown", "1_chair", "2_cup", "3_dining_table____"})
        expected.push_back(folder.file("all") + "/" + name + ".ply");
    EXPECT_EQ(files, expected);
    for (size_t i = 0; i < files.size(); ++i) {
        const Ply ply = parse(test::readFile(files[i]));
        ASSERT_EQ(ply.vertices.size(), 1U) << files[i];
        EXPECT_EQ(ply.vertices[0].at("instanceid"), static_cast<double>(i));
    }
}

TEST(MapPly, unwritable)
{
    WrittenFiles none;
    EXPECT_THROW(exportPlyPerInstance(tinyMap(), "/dev/null/below", none), OutputError);
    EXPECT_TRUE(none.names().empty());
    EXPECT_THROW(exportPly(tinyMap(), "/no/such/folder/map.ply"), OutputError);
    EXPECT_THROW(exportPly(tinyMap(), "/dev/full"), OutputError);
}
