// SPDX-License-Identifier: BSD-3-Clause
#include "exporters/InstancesCsv.h"
#include "exporters/InstancesJson.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voxeland;
using nlohmann::json;
using voxeland::test::TemporaryFolder;
using voxeland::test::tinyMap;

namespace
{
void expectPoint(const json& actual, const std::array<double, 3>& expected)
{
    ASSERT_EQ(actual.size(), 3U);
    for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(actual[a].get<double>(), expected[a], 1e-9);
}
}  // namespace

TEST(InstancesJson, hasUpstreamsLayoutAndOurs)
{
    const TemporaryFolder folder;
    exportJson(tinyMap(), GravityAlignedFrame(), folder.file("i.json"));
    const json all = json::parse(test::readFile(folder.file("i.json")));
    EXPECT_EQ(all["map"]["resolution"], 0.1);
    EXPECT_EQ(all["map"]["entropy_measure"], "expected");
    EXPECT_EQ(all["map"]["categories"], (json{"chair", "table", "cup"}));
    ASSERT_EQ(all["instances"].size(), 2U);

    const json& seat = all["instances"]["obj1"];
    expectPoint(seat["bbox"]["center"], {0.05, 0.05, 0.05});
    expectPoint(seat["bbox"]["size"], {0.1, 0.1, 0.1});
    EXPECT_EQ(seat["results"], (json{{"chair", 2.0}, {"table", 2.0}}));
    EXPECT_EQ(seat["n_observations"], 3);
    EXPECT_EQ(seat["id"], 1);
    EXPECT_EQ(seat["category"], "chair");
    EXPECT_EQ(seat["probability"], 0.5);
    EXPECT_NEAR(seat["entropy"].get<double>(), test::H_CATEGORY_2_2, 1e-9);
    EXPECT_NEAR(seat["geometric_entropy"].get<double>(), test::H_INSTANCE_10_1, 1e-9);
    EXPECT_EQ(seat["vacuity"], 0);

    const json& cup = all["instances"]["obj2"];
    EXPECT_EQ(cup["voxels"], 1) << "the voxel believed free does not count";
    expectPoint(cup["centroid"], {0.15, 0.05, 0.05});
    expectPoint(cup["oriented_box"]["center"], {0.15, 0.05, 0.05});
    expectPoint(cup["oriented_box"]["size"], {0.1, 0.1, 0.1});
    EXPECT_EQ(cup["oriented_box"]["yaw"], 0);
}

TEST(InstancesJson, bytesThatAreNoTextDoNotStopIt)
{
    SemanticVoxelMap map = tinyMap();
    map.categories().add("\xff");
    EXPECT_TRUE(json::accept(instancesAsJson(map, GravityAlignedFrame())));
}

TEST(InstancesCsv, oneLineAnInstance)
{
    SemanticVoxelMap map = tinyMap();
    test::addVoxel(map, {2, 2, 2}, {{test::addInstance(map, {{"cup, \"big\"", 1}}), 5}});
    const TemporaryFolder folder;
    exportCsv(map, GravityAlignedFrame(), folder.file("i.csv"));
    EXPECT_EQ(test::readFile(folder.file("i.csv")),
              "id,category,probability,entropy,vacuity,geometric_entropy,observations,voxels,"
              "centroid_x,centroid_y,centroid_z,min_x,min_y,min_z,max_x,max_y,max_z,"
              "box_x,box_y,box_z,box_length,box_width,box_height,box_yaw\n"
              "1,chair,0.5,0.583333,0,0.26627,3,1,0.05,0.05,0.05,0,0,0,0.1,0.1,0.1,"
              "0.05,0.05,0.05,0.1,0.1,0.1,0\n"
              "2,cup,1,0,0,0.5,3,1,0.15,0.05,0.05,0.1,0,0,0.2,0.1,0.1,"
              "0.15,0.05,0.05,0.1,0.1,0.1,0\n"
              "3,\"cup, \"\"big\"\"\",1,0,0,0,3,1,0.25,0.25,0.25,0.2,0.2,0.2,0.3,0.3,0.3,"
              "0.25,0.25,0.25,0.1,0.1,0.1,0\n");
}

TEST(InstanceTables, unwritable)
{
    EXPECT_THROW(exportJson(tinyMap(), GravityAlignedFrame(), "/no/such/folder/a"), OutputError);
    EXPECT_THROW(exportCsv(tinyMap(), GravityAlignedFrame(), "/dev/full"), OutputError);
}
