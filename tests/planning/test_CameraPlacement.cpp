// SPDX-License-Identifier: BSD-3-Clause
#include "planning/CameraPlacement.h"
#include "planning/Reobservation.h"
#include "support/TinyMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace voxeland;
using mrpt::math::TPoint3D;

namespace
{
/** Voxels of a hall of 6 x 6 x 2.4 m, seen whole. */
constexpr int WIDE = 60, HIGH = 24;

/** The hall, with a floor and a box of 0.4 m in its middle, 0.8 m above the floor, of which nobody
 *  knows whether it is a chair or a table. \param at gives the voxel of a level place, so that the
 *  map's axes may be a camera's */
struct Hall
{
    using Placing = std::function<VoxelCoord(int, int, int)>;

    explicit Hall(Placing placing) : at(std::move(placing))
    {
        for (int z = 0; z < HIGH; ++z)
            for (int y = 0; y < WIDE; ++y)
                for (int x = 0; x < WIDE; ++x) setOccupancy(x, y, z, 0.2);
        for (int y = 0; y < WIDE; ++y)
            for (int x = 0; x < WIDE; ++x) put(x, y, 0, UNKNOWN_INSTANCE);
        object = test::addInstance(map, {{"chair", 2}, {"table", 2}});
        for (int z = 8; z < 12; ++z)
            for (int y = 28; y < 32; ++y)
                for (int x = 28; x < 32; ++x) {
                    put(x, y, z, object);
                    voxels.push_back(at(x, y, z));
                }
    }

    void setOccupancy(int x, int y, int z, double p)
    {
        const VoxelCoord v = at(x, y, z);
        map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), OccupancyFilter::fromProbability(p));
    }
    void put(int x, int y, int z, instance_id_t id) { test::addVoxel(map, at(x, y, z), {{id, 3}}); }

    Placing at;
    SemanticVoxelMap map = test::emptyMap();
    instance_id_t object = 0;
    std::vector<VoxelCoord> voxels;
};

Hall levelHall()
{
    return Hall([](int x, int y, int z) { return VoxelCoord{x, y, z}; });
}

std::vector<CameraPose> posesIn(const Hall& hall)
{
    return placeCamera(hall.map, GravityAlignedFrame(), CarriedCamera(),
                       floorHeight(hall.map, GravityAlignedFrame()), hall.voxels);
}

TPoint3D along(const CameraPose& p, double distance)
{
    return p.pose.composePoint(TPoint3D(distance, 0, 0));
}
}  // namespace

/** The floor's top is at 0.1 m, so the camera is at 1.3 m. A ball around the box has a radius of
 *  0.15 m times the square root of 3, plus a voxel; it fits into 45 degrees from a distance of 0.94
 *  m, and is looked at from 1.2 times that. */
TEST(CameraPlacement, looksAtTheMiddleFromWhereItFits)
{
    const auto poses = posesIn(levelHall());
    ASSERT_EQ(poses.size(), 3U);
    for (const CameraPose& p : poses) {
        EXPECT_NEAR(p.pose.z(), 1.3, 1e-6);
        EXPECT_NEAR(p.distance, 1.2 * 0.3598 / std::sin(22.5 * M_PI / 180), 1e-3);
        const TPoint3D middle = along(p, p.distance);
        for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(middle[a], a < 2 ? 3.0 : 1.0, 1e-6);
        EXPECT_NEAR(std::remainder(p.pose.yaw() - p.yaw, 2 * M_PI), 0, 1e-9);
        EXPECT_NEAR(p.pose.pitch(), p.pitch, 1e-9);
        EXPECT_GT(p.pitch, 0) << "down";
        EXPECT_EQ(p.visible, 1);
    }
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_GE(std::abs(std::remainder(poses[i].yaw - poses[j].yaw, 2 * M_PI)),
                      M_PI / 4 - 1e-6);
}

/** A screen from floor to ceiling, between the box and x > 3.5. */
TEST(CameraPlacement, nothingMayHideIt)
{
    Hall hall = levelHall();
    for (int z = 1; z < HIGH; ++z)
        for (int y = 0; y < WIDE; ++y) hall.put(35, y, z, UNKNOWN_INSTANCE);
    const auto poses = posesIn(hall);
    ASSERT_FALSE(poses.empty());
    for (const CameraPose& p : poses) EXPECT_LT(p.pose.x(), 3.5 - 0.2) << "0.2: its bearer";
}

/** The same, but nobody knows what is there. */
TEST(CameraPlacement, itMustBeSeenThroughKnownSpace)
{
    Hall hall = levelHall();
    for (int z = 1; z < HIGH; ++z)
        for (int y = 0; y < WIDE; ++y) {
            const VoxelCoord v = hall.at(35, y, z);
            hall.map.blocks().at(blockOf(v)).setOccupancy(cellOf(v), UNOBSERVED);
        }
    for (const CameraPose& p : posesIn(hall)) EXPECT_LT(p.pose.x(), 3.5);
}

/** Low boxes everywhere but in a corridor along +y. */
TEST(CameraPlacement, itsBearerNeedsRoomToStand)
{
    Hall hall = levelHall();
    for (int y = 0; y < WIDE; ++y)
        for (int x = 0; x < WIDE; ++x)
            if (y < 32 || x < 25 || x >= 35) hall.put(x, y, 4, UNKNOWN_INSTANCE);
    const auto poses = posesIn(hall);
    ASSERT_FALSE(poses.empty());
    for (const CameraPose& p : poses) {
        EXPECT_GT(p.pose.y(), 3.2);
        EXPECT_GT(p.pose.x(), 2.5);
        EXPECT_LT(p.pose.x(), 3.5);
    }
}

TEST(CameraPlacement, noPlaceIsAnAnswer)
{
    Hall hall = levelHall();
    for (int y = 0; y < WIDE; ++y)
        for (int x = 0; x < WIDE; ++x) hall.put(x, y, 4, UNKNOWN_INSTANCE);
    EXPECT_TRUE(posesIn(hall).empty());
}

/** The same hall in a camera's axes: the same views of it. */
TEST(CameraPlacement, isLevelWhateverTheMapsAxes)
{
    const Hall hall([](int x, int y, int z) { return VoxelCoord{x, -1 - z, y}; });
    const GravityAlignedFrame frame({0, -1, 0});
    const auto poses =
        placeCamera(hall.map, frame, CarriedCamera(), floorHeight(hall.map, frame), hall.voxels);
    ASSERT_EQ(poses.size(), 3U);
    const CameraPose& p = poses[0];
    EXPECT_NEAR(p.pose.y(), -1.3, 1e-6);
    const TPoint3D middle = along(p, p.distance);
    EXPECT_NEAR(middle.x, 3, 1e-6);
    EXPECT_NEAR(middle.y, -1, 1e-6);
    EXPECT_NEAR(middle.z, 3, 1e-6);
    const TPoint3D left = p.pose.rotateVector(TPoint3D(0, 1, 0));
    EXPECT_NEAR(left.y, 0, 1e-9) << "level";
    EXPECT_LT(p.pose.rotateVector(TPoint3D(0, 0, 1)).y, 0) << "not upside down";
}

TEST(Reobservation, theMostUncertainFirst)
{
    Hall hall = levelHall();
    const auto sure = test::addInstance(hall.map, {{"cup", 5}});
    for (int x = 10; x < 20; ++x) hall.put(x, 10, 8, sure);
    const auto small = test::addInstance(hall.map, {{"cup", 1}, {"bowl", 1}});
    for (int x = 40; x < 44; ++x) hall.put(x, 10, 8, small);
    // A block of 5 x 5 voxels that two instances claim: expected entropy of (1,1), 0.5 nat.
    for (int y = 40; y < 45; ++y)
        for (int x = 40; x < 45; ++x)
            test::addVoxel(hall.map, {x, y, 8}, {{sure, 1}, {UNKNOWN_INSTANCE, 1}});
    const auto all = planReobservation(hall.map, GravityAlignedFrame(), CarriedCamera());
    ASSERT_GE(all.size(), 3U);
    EXPECT_EQ(all[0].instance, hall.object);
    EXPECT_EQ(all[0].category, "chair");
    EXPECT_NEAR(all[0].uncertainty, test::H_CATEGORY_2_2, 1e-9);
    EXPECT_EQ(all[0].voxels, 64U);
    EXPECT_NEAR(all[0].center.z, 1, 1e-9);
    EXPECT_EQ(all[0].poses.size(), 3U);
    EXPECT_FALSE(all[1].instance);
    EXPECT_NEAR(all[1].uncertainty, 0.5, 1e-9);
    EXPECT_EQ(all[1].voxels, 25U);
    for (const ReobservationTarget& t : all) EXPECT_NE(t.instance, small) << "too small";
    EXPECT_EQ(planReobservation(hall.map, GravityAlignedFrame(), CarriedCamera(), 1).size(), 1U);
    EXPECT_TRUE(
        planReobservation(SemanticVoxelMap(), GravityAlignedFrame(), CarriedCamera()).empty());
}
