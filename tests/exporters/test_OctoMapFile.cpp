// SPDX-License-Identifier: BSD-3-Clause
/** Files read back with the OctoMap library. */
#include "exporters/OctoMapFile.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

#include <octomap/OcTree.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
using voxeland::test::tinyMap;

namespace
{
/** A cube of 8 x 8 x 8 free voxels, which an octree holds in one node. */
SemanticVoxelMap withFreeCube()
{
    SemanticVoxelMap map = tinyMap();
    for (int cell = 0; cell < BLOCK_CELLS; ++cell)
        map.blocks().at({-1, 2, 3}).setOccupancy(cell, -500);
    return map;
}
}  // namespace

TEST(OctoMapFile, binaryTellsFreeFromOccupied)
{
    const TemporaryFolder folder;
    exportOctoMap(withFreeCube(), folder.file("m.bt"));
    octomap::OcTree tree(1);
    ASSERT_TRUE(tree.readBinary(folder.file("m.bt")));
    EXPECT_EQ(tree.getResolution(), 0.1);
    const auto occupied = [&](double x, double y, double z) {
        const octomap::OcTreeNode* node = tree.search(x, y, z);
        EXPECT_NE(node, nullptr) << x << " " << y << " " << z;
        return node != nullptr && tree.isNodeOccupied(node);
    };
    EXPECT_TRUE(occupied(0.05, 0.05, 0.05));
    EXPECT_TRUE(occupied(0.15, 0.05, 0.05));
    EXPECT_TRUE(occupied(-0.05, -0.05, -0.05));
    EXPECT_FALSE(occupied(0.55, 0.55, 0.55));
    EXPECT_FALSE(occupied(-0.75, 1.65, 2.45));
    EXPECT_EQ(tree.search(0.05, 0.15, 0.05), nullptr) << "never observed";
    EXPECT_EQ(tree.getNumLeafNodes(), 5U) << "the cube is one leaf";
}

TEST(OctoMapFile, fullTreeHoldsProbabilities)
{
    const TemporaryFolder folder;
    exportOctoMap(tinyMap(), folder.file("m.ot"));
    const std::unique_ptr<octomap::AbstractOcTree> read(
        octomap::AbstractOcTree::read(folder.file("m.ot")));
    const auto* tree = dynamic_cast<const octomap::OcTree*>(read.get());
    ASSERT_NE(tree, nullptr);
    EXPECT_NEAR(tree->search(0.15, 0.05, 0.05)->getOccupancy(), 0.8, 1e-3);
    EXPECT_NEAR(tree->search(0.55, 0.55, 0.55)->getOccupancy(), 0.2, 1e-3);
}

TEST(OctoMapFile, refusesWhatItCannotDo)
{
    const TemporaryFolder folder;
    EXPECT_THROW(exportOctoMap(tinyMap(), folder.file("m.oct")), ConfigurationError);
    EXPECT_THROW(exportOctoMap(tinyMap(), "/no/such/folder/m.bt"), OutputError);
    SemanticVoxelMap far = tinyMap();
    test::addVoxel(far, {40000, 0, 0}, {{UNKNOWN_INSTANCE, 1}});
    EXPECT_THROW(exportOctoMap(far, folder.file("m.bt")), ConfigurationError);
}
