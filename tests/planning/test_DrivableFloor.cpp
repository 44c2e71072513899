// SPDX-License-Identifier: BSD-3-Clause
/** A room made by hand: 4 m by 4 m of observed floor with a box and a wall on it. */
#include "support/TinyMap.h"
#include "voxeland/planning/DrivableFloor.h"

#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>

using namespace voxeland;
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TPose2D;

namespace
{
constexpr double MIDDLE_X = 2, MIDDLE_Y = 2;    // of the box [m]
constexpr double HALF = 0.3, BOX_HEIGHT = 0.6;  // [m]
constexpr double ROOM = 4;

/** Whether a place is inside the box, or the wall if there is one. */
bool isSolid(double x, double y, double z, bool wall)
{
    const bool box =
        std::abs(x - MIDDLE_X) < HALF && std::abs(y - MIDDLE_Y) < HALF && z < BOX_HEIGHT;
    return box || (wall && x > 2.6 && x < 2.7);
}

/** Floor up to z = 0; free space, the box and the wall above it. */
SemanticVoxelMap room(bool wall = false)
{
    SemanticVoxelMap map = test::emptyMap();
    const instance_id_t box = test::addInstance(map, {{"box", 3}});
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y) {
            test::addVoxel(map, {x, y, -1}, {{UNKNOWN_INSTANCE, 1}});
            for (int z = 0; z < 20; ++z) {
                const auto p = voxelCenter<TPoint3D>(VoxelCoord{x, y, z}, map.resolution());
                const bool solid = isSolid(p.x, p.y, p.z, wall);
                if (solid)
                    test::addVoxel(map, {x, y, z}, {{p.x < 2.5 ? box : UNKNOWN_INSTANCE, 1}});
                else
                    map.blocks()
                        .at(blockOf(VoxelCoord{x, y, z}))
                        .setOccupancy(cellOf(VoxelCoord{x, y, z}),
                                      OccupancyFilter::fromProbability(0.2));
            }
        }
    return map;
}

OrientedBox boxOf(const SemanticVoxelMap& map)
{
    return orientedBoxes(map, GravityAlignedFrame()).at(1);
}

/** By points all over the robot: whether any is in something solid or outside the room. */
bool collides(const TPoint2D& at, double radius, bool wall)
{
    for (double y = -radius; y <= radius; y += 0.01)
        for (double x = -radius; x <= radius; x += 0.01) {
            if (std::hypot(x, y) >= radius) continue;
            const double px = at.x + x, py = at.y + y;
            if (px < 0 || py < 0 || px >= ROOM || py >= ROOM) return true;
            if (isSolid(px, py, 0.5, wall)) return true;
        }
    return false;
}
}  // namespace

TEST(DrivableFloor, FitsWhereNoPointOfTheRobotTouchesAnything)
{
    const SemanticVoxelMap map = room(true);
    const DrivableFloor floor(map, GravityAlignedFrame());
    int free = 0;
    for (double y = -0.63; y < 4.6; y += 0.119)
        for (double x = -0.63; x < 4.6; x += 0.117) {
            EXPECT_EQ(floor.fits({x, y}), !collides({x, y}, 0.25, true)) << x << " " << y;
            free += floor.fits({x, y}) ? 1 : 0;
        }
    EXPECT_GT(free, 200);
}

TEST(DrivableFloor, DrivesUnderWhatIsHigher)
{
    SemanticVoxelMap map = room();
    test::addVoxel(map, {5, 5, 15}, {{UNKNOWN_INSTANCE, 1}});  // 1.5 to 1.6 m
    EXPECT_TRUE(DrivableFloor(map, GravityAlignedFrame()).fits({0.55, 0.55}));
    DrivingRobot tall;
    tall.height = 1.7;
    EXPECT_FALSE(DrivableFloor(map, GravityAlignedFrame(), tall).fits({0.55, 0.55}));
}

TEST(DrivableFloor, PosesFaceTheObjectFromAllSides)
{
    const SemanticVoxelMap map = room();
    const auto poses = DrivableFloor(map, GravityAlignedFrame()).posesFacing(boxOf(map));
    ASSERT_EQ(poses.size(), 32U) << "nothing is in the way";
    double last = 0;
    for (const TPose2D& p : poses) {
        const double dx = MIDDLE_X - p.x, dy = MIDDLE_Y - p.y, distance = std::hypot(dx, dy);
        EXPECT_FALSE(collides({p.x, p.y}, 0.25, false)) << p;
        EXPECT_NEAR(std::remainder(p.phi - std::atan2(dy, dx), 2 * M_PI), 0, 1e-6);
        EXPECT_LE(distance, HALF * std::sqrt(2) + 0.25 + 0.2) << "the first place where it fits";
        EXPECT_GE(distance, last - 1e-9) << "the nearest first";
        last = distance;
    }
    EXPECT_NEAR(std::hypot(poses[0].x - MIDDLE_X, poses[0].y - MIDDLE_Y), HALF + 0.25, 0.1 + 1e-6);
}

TEST(DrivableFloor, WallsHideTheObject)
{
    const SemanticVoxelMap map = room(true);
    const auto poses = DrivableFloor(map, GravityAlignedFrame()).posesFacing(boxOf(map));
    EXPECT_GE(poses.size(), 15U);
    for (const TPose2D& p : poses) EXPECT_LT(p.x, 2.6) << "behind the wall";
    DrivingRobot giant;
    giant.radius = 1;
    giant.reach = 1;
    EXPECT_EQ(DrivableFloor(map, GravityAlignedFrame(), giant).posesFacing(boxOf(map)).size(), 0U)
        << "such a robot fits nowhere near it";
}

TEST(DrivableFloor, WorksInATiltedMap)
{
    // The same room with y up instead of z: (x, y, z) becomes (x, z, -y).
    const SemanticVoxelMap level = room();
    SemanticVoxelMap map = test::emptyMap();
    test::addInstance(map, {{"box", 3}});
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y)
            for (int z = -1; z < 20; ++z) {
                const VoxelCoord from{x, y, z}, to{x, z, -1 - y};
                if (const VoxelEvidence* e = level.evidence(from))
                    map.addEvidence(to, level.winner(*e), 1);
                map.blocks().at(blockOf(to)).setOccupancy(cellOf(to), level.occupancy(from));
            }
    const GravityAlignedFrame frame({0, 1, 0});
    const auto box = orientedBoxes(map, frame).at(1);
    const DrivableFloor floor(map, frame);
    const auto poses = floor.posesFacing(box);
    EXPECT_EQ(poses.size(), 32U);
    const TPoint3D middle = frame.toLevel({MIDDLE_X, 0.3, -MIDDLE_Y});
    for (const TPose2D& p : poses) {
        EXPECT_TRUE(floor.fits({p.x, p.y}));
        EXPECT_NEAR(std::remainder(p.phi - std::atan2(middle.y - p.y, middle.x - p.x), 2 * M_PI), 0,
                    1e-6);
    }
}
