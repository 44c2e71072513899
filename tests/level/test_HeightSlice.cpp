// SPDX-License-Identifier: BSD-3-Clause
#include "Hall.h"
#include "level/HeightSlice.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;
using voxeland::test::hall;
using voxeland::test::levelHall;
using voxeland::test::TemporaryFolder;

namespace
{
constexpr HeightRange BODY = {0.1, 1.0};
}  // namespace

TEST(HeightSlice, theMostOccupiedVoxelOfAColumnDecides)
{
    const HeightSlice slice = sliceOf(levelHall(), GravityAlignedFrame(), BODY);
    ASSERT_EQ(slice.columns, 8U);
    ASSERT_EQ(slice.rows, 8U);
    EXPECT_NEAR(slice.occupancy[5 * 8 + 2], 0.95, 1e-3);
    EXPECT_NEAR(slice.occupancy[1 * 8 + 6], 0.4, 1e-3);
    EXPECT_NEAR(slice.occupancy[0], 0.2, 1e-3);
    const HeightSlice low = sliceOf(levelHall(), GravityAlignedFrame(), {0.01, 0.05});
    EXPECT_NEAR(low.occupancy[0], 0.9, 1e-3) << "the floor";
    EXPECT_THROW(sliceOf(levelHall(), GravityAlignedFrame(), {5, 6}), ConfigurationError);
}

TEST(HeightSlice, heightsFarBeyondTheMapAreItsOwn)
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    const auto map = levelHall();
    const HeightSlice all = sliceOf(map, GravityAlignedFrame(), {-1, 2});
    EXPECT_EQ(sliceOf(map, GravityAlignedFrame(), {-1e300, 1e6}).occupancy, all.occupancy);
    EXPECT_EQ(sliceOf(map, GravityAlignedFrame(), {-INF, INF}).occupancy, all.occupancy);
    EXPECT_EQ(sliceOf(map, GravityAlignedFrame(), {0.1, 1e9}).occupancy,
              sliceOf(map, GravityAlignedFrame(), {0.1, 2}).occupancy);
}

TEST(HeightSlice, whatIsNotObservedIsNeitherFreeNorOccupied)
{
    SemanticVoxelMap map = levelHall();
    test::addVoxel(map, {10, 0, 3}, {{UNKNOWN_INSTANCE, 1}});
    const HeightSlice slice = sliceOf(map, GravityAlignedFrame(), BODY);
    ASSERT_EQ(slice.columns, 11U);
    EXPECT_EQ(slice.occupancy[9], 0.5F);
    EXPECT_GT(slice.occupancy[10], 0.5F);
}

/** The same hall in a camera's axes (y down, z ahead): the same grid. */
TEST(HeightSlice, isLevelWhateverTheMapsAxes)
{
    const auto map = hall([](int x, int y, int z) { return VoxelCoord{x, -1 - z, y}; });
    const HeightSlice slice = sliceOf(map, GravityAlignedFrame({0, -1, 0}), BODY);
    EXPECT_EQ(slice.occupancy, sliceOf(levelHall(), GravityAlignedFrame(), BODY).occupancy);
    EXPECT_NEAR(slice.minX, 0, 1e-9);
    EXPECT_NEAR(slice.minY, 0, 1e-9);
}

TEST(HeightSlice, aTiltedFrameLeavesNoHoles)
{
    const GravityAlignedFrame tilted({0.2, 0.1, 1});
    const HeightSlice slice = sliceOf(levelHall(), tilted, {0.2, 0.5});
    for (size_t row = 2; row < 6; ++row)
        for (size_t column = 2; column < 6; ++column)
            EXPECT_NE(slice.occupancy[row * slice.columns + column], 0.5F) << row << " " << column;
}

TEST(HeightSlice, aGridIsNotLargerThanAnybodyNeeds)
{
    SemanticVoxelMap map = levelHall();
    test::addVoxel(map, {900000, 0, 3}, {{UNKNOWN_INSTANCE, 1}});
    const HeightSlice slice = sliceOf(map, GravityAlignedFrame(), BODY);
    EXPECT_EQ(slice.columns, 900001U);
    EXPECT_NEAR(slice.occupancy[5 * 900001 + 2], 0.95, 1e-3);
    test::addVoxel(map, {0, 900000, 3}, {{UNKNOWN_INSTANCE, 1}});
    try {
        static_cast<void>(sliceOf(map, GravityAlignedFrame(), BODY));
        FAIL() << "no exception";
    } catch (const ConfigurationError& e) {
        EXPECT_NE(std::string(e.what()).find("900001 x 900001"), std::string::npos) << e.what();
    }
}

/** Probabilities of every kind in a tilted frame: what each column's own search says. */
TEST(HeightSlice, isWhatALookAtEachColumnFinds)
{
    SemanticVoxelMap map = levelHall();
    const GravityAlignedFrame tilted({0.2, -0.3, 1});
    const HeightRange heights{0.13, 0.71};
    const HeightSlice slice = sliceOf(map, tilted, heights);
    const double edge = map.resolution();
    for (size_t row = 0; row < slice.rows; ++row)
        for (size_t column = 0; column < slice.columns; ++column) {
            log_odds_t most = UNOBSERVED;
            for (int k = -100; k < 100; ++k) {
                const mrpt::math::TPoint3D place(
                    slice.minX + (static_cast<double>(column) + 0.5) * edge,
                    slice.minY + (static_cast<double>(row) + 0.5) * edge, (k + 0.5) * edge / 2);
                if (heights.contains(place.z))
                    most = std::max(most, map.occupancyAt(tilted.toMap(place)));
            }
            EXPECT_EQ(slice.occupancy[row * slice.columns + column],
                      static_cast<float>(OccupancyFilter::probability(most)))
                << row << " " << column;
        }
}
