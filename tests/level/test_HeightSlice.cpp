// SPDX-License-Identifier: BSD-3-Clause
/** Grids read back with MRPT. */
#include "exporters/TinyMap.h"
#include "level/HeightSlice.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

using namespace voxeland;
using mrpt::maps::COccupancyGridMap2D;
using voxeland::test::TemporaryFolder;

namespace
{
constexpr HeightRange BODY = {0.1, 1.0};

/** Free space of 8 x 8 x 8 voxels, in it a pole, a floor below and a lamp above the heights, as
 *  seen by a camera whose axes may be turned: `at` gives the voxel of a level place. */
template <typename At>
SemanticVoxelMap hall(At&& at)
{
    SemanticVoxelMap map = test::emptyMap();
    const auto set = [&](int x, int y, int z, double p) {
        test::addVoxel(map, at(x, y, z), {{UNKNOWN_INSTANCE, 1}}, p);
    };
    for (int z = 0; z < 8; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) set(x, y, z, z == 0 ? 0.9 : 0.2);
    for (int z = 1; z < 5; ++z) set(2, 5, z, 0.95);
    set(4, 4, 12, 0.9);
    set(6, 1, 3, 0.4);
    return map;
}

SemanticVoxelMap levelHall()
{
    return hall([](int x, int y, int z) { return VoxelCoord{x, y, z}; });
}

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

TEST(HeightSlice, theMostOccupiedVoxelOfAColumnDecides)
{
    const HeightSlice slice = sliceOf(levelHall(), LevelFrame(), BODY);
    ASSERT_EQ(slice.columns, 8U);
    ASSERT_EQ(slice.rows, 8U);
    EXPECT_NEAR(slice.occupancy[5 * 8 + 2], 0.95, 1e-3);
    EXPECT_NEAR(slice.occupancy[1 * 8 + 6], 0.4, 1e-3);
    EXPECT_NEAR(slice.occupancy[0], 0.2, 1e-3);
    const HeightSlice low = sliceOf(levelHall(), LevelFrame(), {0.01, 0.05});
    EXPECT_NEAR(low.occupancy[0], 0.9, 1e-3) << "the floor";
    EXPECT_THROW(sliceOf(levelHall(), LevelFrame(), {5, 6}), ConfigurationError);
}

TEST(HeightSlice, heightsFarBeyondTheMapAreItsOwn)
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    const auto map = levelHall();
    const HeightSlice all = sliceOf(map, LevelFrame(), {-1, 2});
    EXPECT_EQ(sliceOf(map, LevelFrame(), {-1e300, 1e6}).occupancy, all.occupancy);
    EXPECT_EQ(sliceOf(map, LevelFrame(), {-INF, INF}).occupancy, all.occupancy);
    EXPECT_EQ(sliceOf(map, LevelFrame(), {0.1, 1e9}).occupancy,
              sliceOf(map, LevelFrame(), {0.1, 2}).occupancy);
}

TEST(HeightSlice, whatIsNotObservedIsNeitherFreeNorOccupied)
{
    SemanticVoxelMap map = levelHall();
    test::addVoxel(map, {10, 0, 3}, {{UNKNOWN_INSTANCE, 1}});
    const HeightSlice slice = sliceOf(map, LevelFrame(), BODY);
    ASSERT_EQ(slice.columns, 11U);
    EXPECT_EQ(slice.occupancy[9], 0.5F);
    EXPECT_GT(slice.occupancy[10], 0.5F);
}

/** The same hall in a camera's axes (y down, z ahead): the same grid. */
TEST(HeightSlice, isLevelWhateverTheMapsAxes)
{
    const auto map = hall([](int x, int y, int z) { return VoxelCoord{x, -1 - z, y}; });
    const HeightSlice slice = sliceOf(map, LevelFrame({0, -1, 0}), BODY);
    EXPECT_EQ(slice.occupancy, sliceOf(levelHall(), LevelFrame(), BODY).occupancy);
    EXPECT_NEAR(slice.minX, 0, 1e-9);
    EXPECT_NEAR(slice.minY, 0, 1e-9);
}

TEST(HeightSlice, aTiltedFrameLeavesNoHoles)
{
    const LevelFrame tilted({0.2, 0.1, 1});
    const HeightSlice slice = sliceOf(levelHall(), tilted, {0.2, 0.5});
    for (size_t row = 2; row < 6; ++row)
        for (size_t column = 2; column < 6; ++column)
            EXPECT_NE(slice.occupancy[row * slice.columns + column], 0.5F) << row << " " << column;
}

TEST(HeightSlice, mrptReadsTheGridmap)
{
    const TemporaryFolder folder;
    exportGridmap(sliceOf(levelHall(), LevelFrame(), BODY), folder.file("h.gridmap"));
    mrpt::io::CFileGZInputStream in(folder.file("h.gridmap"));
    COccupancyGridMap2D grid;
    mrpt::serialization::archiveFrom(in) >> grid;
    expectHall(grid);
    EXPECT_NEAR(grid.getXMin(), 0, 1e-6);
}

TEST(HeightSlice, mrptReadsTheRosMap)
{
    const TemporaryFolder folder;
    SemanticVoxelMap map = levelHall();
    test::addVoxel(map, {-3, -2, 3}, {{UNKNOWN_INSTANCE, 1}});
    WrittenFiles written;
    exportRosMap(sliceOf(map, LevelFrame(), BODY), folder.file("h.yaml"), written);
    EXPECT_EQ(written.names(),
              std::vector<std::string>({folder.file("h.pgm"), folder.file("h.yaml")}));
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

TEST(HeightSlice, unwritable)
{
    const HeightSlice slice = sliceOf(levelHall(), LevelFrame(), BODY);
    EXPECT_THROW(exportGridmap(slice, "/no/such/folder/h.gridmap"), OutputError);
    WrittenFiles written;
    EXPECT_THROW(exportRosMap(slice, "/no/such/folder/h.yaml", written), OutputError);
    EXPECT_TRUE(written.names().empty());
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("h.yaml"));
    EXPECT_THROW(exportRosMap(slice, folder.file("h.yaml"), written), OutputError);
    EXPECT_EQ(written.names(), std::vector<std::string>{folder.file("h.pgm")});
}
