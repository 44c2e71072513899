// SPDX-License-Identifier: BSD-3-Clause
/** Points read back with MRPT. */
#include "exporters/PointsFile.h"
#include "support/TestFiles.h"
#include "support/TinyMap.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/serialization/CArchive.h>

using namespace voxeland;
using mrpt::maps::CSimplePointsMap;
using voxeland::test::TemporaryFolder;
using voxeland::test::tinyMap;

namespace
{
/** Points of the tiny map, by way of a file. */
CSimplePointsMap filtered(const PointsFilter& filter)
{
    const TemporaryFolder folder;
    const size_t count = exportPoints(tinyMap(), filter, folder.file("p.txt"));
    CSimplePointsMap points;
    EXPECT_TRUE(points.load3D_from_text_file(folder.file("p.txt")) || count == 0);
    EXPECT_EQ(points.size(), count);
    return points;
}
}  // namespace

TEST(PointsFile, allOccupiedVoxelsByDefault)
{
    EXPECT_EQ(filtered({}).size(), 3U);
}

TEST(PointsFile, someCategories)
{
    PointsFilter filter;
    filter.categories = {"CUP"};
    const CSimplePointsMap cup = filtered(filter);
    ASSERT_EQ(cup.size(), 1U);
    float x = 0, y = 0, z = 0;
    cup.getPoint(0, x, y, z);
    EXPECT_NEAR(x, 0.15, 1e-4);
    EXPECT_NEAR(y, 0.05, 1e-4);
    EXPECT_NEAR(z, 0.05, 1e-4);
    filter.categories = {"cup", "unknown"};
    EXPECT_EQ(filtered(filter).size(), 2U);
    filter.categories = {"sofa"};
    EXPECT_EQ(filtered(filter).size(), 0U);
}

TEST(PointsFile, allButSomeCategories)
{
    PointsFilter filter;
    filter.except = {"Cup", "person"};
    const CSimplePointsMap others = pointsOf(tinyMap(), filter);
    ASSERT_EQ(others.size(), 2U);
    for (size_t i = 0; i < others.size(); ++i) {
        float x = 0, y = 0, z = 0;
        others.getPoint(i, x, y, z);
        EXPECT_LT(x, 0.1F) << "the cup is at 0.15";
    }
    filter.categories = {"cup", "unknown"};
    EXPECT_EQ(pointsOf(tinyMap(), filter).size(), 1U) << "what both name is left out";
}

TEST(PointsFile, someHeights)
{
    PointsFilter filter;
    filter.heights = {0, 1};
    EXPECT_EQ(filtered(filter).size(), 2U) << "one voxel is below the origin";
    filter.frame = GravityAlignedFrame({0, -1, 0});
    EXPECT_EQ(filtered(filter).size(), 1U);
}

TEST(PointsFile, serializedAndAsAScene)
{
    const TemporaryFolder folder;
    exportPoints(tinyMap(), {}, folder.file("p.metricmap"));
    mrpt::io::CFileGZInputStream in(folder.file("p.metricmap"));
    CSimplePointsMap points;
    mrpt::serialization::archiveFrom(in) >> points;
    EXPECT_EQ(points.size(), 3U);
    exportPoints(tinyMap(), {}, folder.file("p.3Dscene"));
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile(folder.file("p.3Dscene")));
    EXPECT_NEAR(scene.getBoundingBox().max.x, 0.15, 1e-4);
}

TEST(PointsFile, refusesWhatItCannotDo)
{
    const TemporaryFolder folder;
    EXPECT_THROW(exportPoints(tinyMap(), {}, folder.file("p.las")), ConfigurationError);
    for (const char* name : {"p.txt", "p.metricmap", "p.3Dscene"})
        EXPECT_THROW(exportPoints(tinyMap(), {}, folder.file("absent/") + name), OutputError);
}
