// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/Apartment.h"
#include "voxeland/simulation/CameraPath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace voxeland::simulation;

namespace
{
Scene apartment(int rooms)
{
    SceneOptions options;
    options.rooms = rooms;
    return makeApartment(options, Random(11));
}
}  // namespace

TEST(CameraPath, GoesThroughAllRoomsAndThroughNoSolid)
{
    for (const int rooms : {1, 2, 3}) {
        const Scene scene = apartment(rooms);
        CameraOptions options;
        options.frames = 400;
        const CameraPath path(scene, options, Random(1));
        ASSERT_EQ(path.poses().size(), 400U);
        std::set<size_t> visited;
        for (const auto& pose : path.poses()) {
            const Vector3 p(static_cast<float>(pose.x), static_cast<float>(pose.y),
                            static_cast<float>(pose.z));
            for (const auto& part : scene.parts()) ASSERT_FALSE(part.solid.contains(p, -0.05F));
            for (size_t i = 0; i < scene.rooms().size(); ++i)
                if (p.x > scene.rooms()[i].minX && p.x < scene.rooms()[i].maxX) visited.insert(i);
            EXPECT_NEAR(p.z, 1.45F, 0.15F);
        }
        EXPECT_EQ(visited.size(), static_cast<size_t>(rooms));
    }
}

TEST(CameraPath, MovesAndTurnsSmoothly)
{
    CameraOptions options;
    options.frames = 3000;
    const auto poses = CameraPath(apartment(2), options, Random(1)).poses();
    for (size_t i = 1; i < poses.size(); ++i) {
        const auto &a = poses[i - 1], &b = poses[i];
        EXPECT_LT(std::hypot(b.x - a.x, b.y - a.y, b.z - a.z), 0.06);
        EXPECT_LT(std::abs(std::remainder(b.yaw - a.yaw, 2 * M_PI)), 0.09);
    }
}
