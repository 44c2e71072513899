// SPDX-License-Identifier: BSD-3-Clause
/** Grids read back with MRPT. */
#include "exporters/GridFiles.h"
#include "level/Hall.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>

using namespace voxeland;
using namespace voxeland::test;
using mrpt::maps::COccupancyGridMap2D;

namespace
{
constexpr HeightRange BODY = {0.1, 1.0};

template <typename Grid>
void expectHall(const Grid& grid)
{
    EXPECT_NEAR(grid.getResolution(), 0.1F, 1e-6F);
    EXPECT_EQ(grid.getSizeX(), 8U);
    EXPECT_EQ(grid.getSizeY(), 8U);
    EXPECT_LT(grid.getPos(0.25F, 0.55F), 0.2F) << "the pole: MRPT's cells say how free they are";
    EXPECT_GT(grid.getPos(0.25F, 0.45F), 0.7F);
    EXPECT_GT(grid.getPos(0.45F, 0.45F), 0.7F) << "under the lamp";
}
}  // namespace

TEST(GridFiles, mrptReadsTheGridmap)
{
    const TemporaryFolder folder;
    exportGridmap(sliceOf(levelHall(), GravityAlignedFrame(), BODY), folder.file("h.gridmap"));
    mrpt::io::CFileGZInputStream in(folder.file("h.gridmap"));
    COccupancyGridMap2D grid;
    mrpt::serialization::archiveFrom(in) >> grid;
    expectHall(grid);
    EXPECT_NEAR(grid.getXMin(), 0, 1e-6);
}

TEST(GridFiles, mrptReadsTheRosMap)
{
    const TemporaryFolder folder;
    SemanticVoxelMap map = levelHall();
    test::addVoxel(map, {-3, -2, 3}, {{UNKNOWN_INSTANCE, 1}});
    WrittenFiles written;
    exportRosMap(sliceOf(map, GravityAlignedFrame(), BODY), folder.file("h.yaml"), written);
    EXPECT_EQ(written.names(),
              (std::vector<std::string>{folder.file("h.pgm"), folder.file("h.yaml")}));
    COccupancyGridMap2D grid;
    ASSERT_TRUE(grid.loadFromROSMapServerYAML(folder.file("h.yaml")));
    EXPECT_EQ(grid.getSizeX(), 11U);
    EXPECT_EQ(grid.getSizeY(), 10U);
    EXPECT_NEAR(grid.getXMin(), -0.3, 1e-6);
    EXPECT_NEAR(grid.getYMin(), -0.2, 1e-6);
    EXPECT_LT(grid.getPos(0.25F, 0.55F), 0.2F);
    EXPECT_GT(grid.getPos(0.25F, 0.45F), 0.8F);
    EXPECT_NEAR(grid.getPos(-0.15F, 0.45F), 0.5, 0.35);
    EXPECT_THROW(exportRosMap(HeightSlice(), folder.file("h.yml"), written), ConfigurationError);
}

TEST(GridFiles, unwritable)
{
    const HeightSlice slice = sliceOf(levelHall(), GravityAlignedFrame(), BODY);
    EXPECT_THROW(exportGridmap(slice, "/no/such/folder/h.gridmap"), OutputError);
    WrittenFiles written;
    EXPECT_THROW(exportRosMap(slice, "/no/such/folder/h.yaml", written), OutputError);
    EXPECT_TRUE(written.names().empty());
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("h.yaml"));
    EXPECT_THROW(exportRosMap(slice, folder.file("h.yaml"), written), OutputError);
    EXPECT_EQ(written.names(), std::vector<std::string>{folder.file("h.pgm")});
}
