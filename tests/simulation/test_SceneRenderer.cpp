// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/Apartment.h"
#include "voxeland/simulation/SceneRenderer.h"

#include <gtest/gtest.h>

#include <limits>

using namespace voxeland::simulation;

namespace
{
CameraOptions smallImage()
{
    CameraOptions options;
    options.width = 160;
    options.height = 120;
    return options;
}

Solid box(const Vector3& center, const Vector3& halfSize)
{
    return {Solid::Shape::Box, {center.x, center.y, center.z, 0, 0, 0}, halfSize, {}};
}
}  // namespace

TEST(SceneRenderer, IntrinsicsScaleWithTheImage)
{
    const RenderCamera full{CameraOptions{}}, quarter{smallImage()};
    EXPECT_FLOAT_EQ(full.focal, 525);
    EXPECT_FLOAT_EQ(full.cx, 319.5F);
    EXPECT_FLOAT_EQ(full.cy, 239.5F);
    EXPECT_FLOAT_EQ(quarter.focal, 131.25F);
    EXPECT_FLOAT_EQ(quarter.cx, 79.5F);
}

TEST(SceneRenderer, AWallAheadHasOneDepthAllOver)
{
    Scene scene;
    scene.addSolid(box({3.05F, 0, 0}, {0.05F, 10, 10}));
    const RenderCamera camera(smallImage());
    const auto view = SceneRenderer(scene, camera).render({1, 0, 0, 0, 0, 0});
    for (const float z : view.depth) EXPECT_NEAR(z, 2, 1e-5F);
    // The ray through the image's corner leaves at (79.5, 59.5) pixels from its centre.
    const float slant = std::sqrt(1 + (79.5F * 79.5F + 59.5F * 59.5F) / (131.25F * 131.25F));
    EXPECT_NEAR(view.cosines.front(), 1 / slant, 1e-5F);
}

TEST(SceneRenderer, TheFloorRecedesTowardsTheHorizon)
{
    Scene scene;
    scene.addSolid(box({0, 0, -0.5F}, {1000, 1000, 0.5F}));
    const RenderCamera camera(smallImage());
    const auto view = SceneRenderer(scene, camera).render({0, 0, 1.5, 0.7, 0, 0});
    for (const int row : {0, 59}) EXPECT_EQ(view.depth[static_cast<size_t>(row) * 160], 0) << row;
    for (const int row : {70, 90, 119}) {
        const float expected = 1.5F * 131.25F / (static_cast<float>(row) - 59.5F);
        EXPECT_NEAR(view.depth[static_cast<size_t>(row) * 160 + 17], expected, 1e-3F * expected);
    }
}

TEST(SceneRenderer, LeftIsLeftAndUpIsUp)
{
    Scene scene;
    const auto left = scene.addObject("left"), top = scene.addObject("top");
    scene.addSolid(box({2, 0.5F, 0}, {0.1F, 0.1F, 0.1F}), left);
    scene.addSolid(box({2, 0, 0.5F}, {0.1F, 0.1F, 0.1F}), top);
    const RenderCamera camera(smallImage());
    const SceneRenderer renderer(scene, camera);
    const auto view = renderer.render({});
    // 0.5 m aside at 2 m (front face 1.9 m): 131.25 * 0.5 / 1.9 = 34.5 pixels from the middle
    EXPECT_EQ(view.objects[60 * 160 + 45], left);
    EXPECT_EQ(view.objects[25 * 160 + 80], top);
    EXPECT_EQ(view.objects[60 * 160 + 114], STRUCTURE);
    const auto down = renderer.render({0, 0, 0, 0, 0.25, 0});  // MRPT: positive pitch looks down
    EXPECT_EQ(down.objects[25 * 160 + 80], STRUCTURE);
}

TEST(SceneRenderer, AgreesWithRaysSentOneByOne)
{
    const Scene scene = makeApartment({}, Random(3));
    const RenderCamera camera(smallImage());
    const mrpt::math::TPose3D pose(2.5, 2.4, 1.4, 1.1, 0.35, 0.05);
    const auto view = SceneRenderer(scene, camera).render(pose);
    const CameraFrame frame(pose);
    for (int v = 1; v < 120; v += 7)
        for (int u = 2; u < 160; u += 5) {
            const Vector3 ray = frame.forward -
                                frame.left * ((static_cast<float>(u) - 79.5F) / 131.25F) -
                                frame.up * ((static_cast<float>(v) - 59.5F) / 131.25F);
            float nearest = std::numeric_limits<float>::infinity();
            for (const auto& part : scene.parts())
                nearest =
                    std::min(nearest, part.solid.intersect(frame.origin, ray).value_or(nearest));
            const auto i = static_cast<size_t>(v) * 160 + static_cast<size_t>(u);
            EXPECT_NEAR(view.depth[i], nearest, 1e-4F) << u << " " << v;
        }
}

TEST(RenderCamera, ProjectsPointsToThePixelTheyWereSeenAt)
{
    const RenderCamera camera(smallImage());
    const CameraFrame frame({1, 2, 3, 0.4, 0.2, -0.1});
    const Vector3 ray = frame.forward - frame.left * ((100 - 79.5F) / 131.25F) -
                        frame.up * ((30 - 59.5F) / 131.25F);
    const auto pixel = camera.project(frame, frame.origin + ray * 2.5F);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(pixel->index, 30U * 160 + 100);
    EXPECT_NEAR(pixel->depth, 2.5F, 1e-5F);
    EXPECT_FALSE(camera.project(frame, frame.origin - ray));
    EXPECT_FALSE(camera.project(frame, frame.origin + frame.forward + frame.left));
}
