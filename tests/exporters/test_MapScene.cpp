// SPDX-License-Identifier: BSD-3-Clause
/** Scenes read back with MRPT. */
#include "exporters/MapScene.h"
#include "pictures/Colors.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"
#include "voxeland/level/GravityAlignedFrame.h"

#include <gtest/gtest.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>

using namespace voxeland;
using voxeland::test::TemporaryFolder;
using voxeland::test::tinyMap;

TEST(MapScene, cubesHaveTheColoursOfInstances)
{
    const auto cubes = voxelCubes(tinyMap());
    ASSERT_EQ(cubes->getVoxelCount(0), 3U);
    const auto colors = instanceColors(tinyMap());
    for (size_t i = 0; i < 3; ++i) {
        const auto& cube = cubes->getVoxel(0, i);
        EXPECT_NEAR(cube.side_length, 0.1, 1e-6);
        const instance_id_t id = cube.coords.x > 0.1F ? 2 : cube.coords.x > 0 ? 1 : 0;
        const Color color = {cube.color.R, cube.color.G, cube.color.B};
        EXPECT_EQ(color, colors.at(id)) << id;
    }
}

/** In a camera's axes, what is at y = -0.1 to 0.1 of the map is at z = -0.1 to 0.1 of the scene. */
TEST(MapScene, isLevelAndNamesTheInstances)
{
    const TemporaryFolder folder;
    exportScene(tinyMap(), GravityAlignedFrame({0, -1, 0}), folder.file("m.3Dscene"));
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile(folder.file("m.3Dscene")));
    EXPECT_NE(scene.getByName("1 chair"), nullptr);
    EXPECT_NE(scene.getByName("2 cup"), nullptr);
    const auto box = scene.getBoundingBox();
    EXPECT_NEAR(box.min.x, -0.1, 1e-5);
    EXPECT_NEAR(box.max.x, 0.2, 1e-5);
    EXPECT_NEAR(box.min.y, -0.1, 1e-5) << "the map's z";
    EXPECT_NEAR(box.min.z, -0.1, 1e-5) << "the map's -y";
}

TEST(MapScene, emptyAndUnwritable)
{
    const TemporaryFolder folder;
    EXPECT_NO_THROW(
        exportScene(SemanticVoxelMap(), GravityAlignedFrame(), folder.file("e.3Dscene")));
    EXPECT_THROW(exportScene(tinyMap(), GravityAlignedFrame(), "/no/such/folder/m.3Dscene"),
                 OutputError);
}
