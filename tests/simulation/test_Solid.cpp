// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace voxeland::simulation;

namespace
{
using Shape = Solid::Shape;

Solid at(Shape shape, const mrpt::math::TPose3D& pose, const Vector3& halfSize)
{
    return {shape, pose, halfSize, {}};
}
}  // namespace

TEST(Solid, RayEntersABoxAtItsNearFace)
{
    const Solid box = at(Shape::Box, {5, 0, 0, 0, 0, 0}, {1, 2, 3});
    EXPECT_FLOAT_EQ(box.intersect({0, 0, 0}, {1, 0, 0}).value(), 4);
    EXPECT_FLOAT_EQ(box.intersect({0, 0, 0}, {2, 0, 0}).value(), 2);  // in lengths of direction
    EXPECT_FLOAT_EQ(box.intersect({5, -7, 0}, {0, 1, 0}).value(), 5);
    EXPECT_FLOAT_EQ(box.intersect({5, 0, 13}, {0, 0, -1}).value(), 10);
}

TEST(Solid, RayMissesWhatIsBesideBehindOrAroundIt)
{
    const Solid box = at(Shape::Box, {5, 0, 0, 0, 0, 0}, {1, 1, 1});
    EXPECT_FALSE(box.intersect({0, 1.01F, 0}, {1, 0, 0}));
    EXPECT_FALSE(box.intersect({0, 0, 0}, {-1, 0, 0}));
    EXPECT_FALSE(box.intersect({5, 0, 0}, {1, 0, 0})) << "starts inside";
    const Solid cylinder = at(Shape::Cylinder, {5, 0, 0, 0, 0, 0}, {1, 1, 1});
    EXPECT_FALSE(cylinder.intersect({0, 0.9F, 1.1F}, {1, 0, 0}));
    EXPECT_FALSE(cylinder.intersect({4.2F, 0.8F, 5}, {0, 0, -1})) << "in the box, not the circle";
    const Solid ball = at(Shape::Ellipsoid, {5, 0, 0, 0, 0, 0}, {1, 1, 1});
    EXPECT_FALSE(ball.intersect({0, 0.8F, 0.8F}, {1, 0, 0}));
}

TEST(Solid, RayEntersATurnedBoxAtItsEdge)
{
    // Turned by 45 degrees a cube with side 2 has an edge sqrt(2) before its centre.
    const Solid box = at(Shape::Box, {5, 0, 0, M_PI / 4, 0, 0}, {1, 1, 1});
    EXPECT_NEAR(box.intersect({0, 0, 0}, {1, 0, 0}).value(), 5 - std::sqrt(2.0F), 1e-5F);
    // Tilted about y instead, likewise; the line y = 0.5 still meets that edge.
    const Solid tilted = at(Shape::Box, {5, 0, 0, 0, M_PI / 4, 0}, {1, 1, 1});
    EXPECT_NEAR(tilted.intersect({0, 0.5F, 0}, {1, 0, 0}).value(), 5 - std::sqrt(2.0F), 1e-5F);
}

TEST(Solid, RayEntersACylinderAtItsSideOrCap)
{
    const Solid cylinder = at(Shape::Cylinder, {5, 0, 1, 0, 0, 0}, {0.5F, 0.5F, 1});
    EXPECT_FLOAT_EQ(cylinder.intersect({0, 0, 1}, {1, 0, 0}).value(), 4.5F);
    // Off the axis by 0.3 the half chord is 0.4.
    EXPECT_FLOAT_EQ(cylinder.intersect({0, 0.3F, 1}, {1, 0, 0}).value(), 4.6F);
    EXPECT_FLOAT_EQ(cylinder.intersect({5.2F, 0.2F, 4}, {0, 0, -1}).value(), 2);
    // Diagonally from above the cap comes first: z = 2 is reached at t = 1, there x = 5.
    EXPECT_FLOAT_EQ(cylinder.intersect({4, 0, 3}, {1, 0, -1}).value(), 1);
}

TEST(Solid, RayEntersAnEllipsoid)
{
    const Solid ball = at(Shape::Ellipsoid, {5, 0, 0, 0, 0, 0}, {1, 1, 1});
    EXPECT_FLOAT_EQ(ball.intersect({0, 0, 0}, {1, 0, 0}).value(), 4);
    EXPECT_FLOAT_EQ(ball.intersect({0, 0.6F, 0}, {1, 0, 0}).value(), 4.2F);  // 1 = 0.36 + 0.64
    const Solid flat = at(Shape::Ellipsoid, {5, 0, 0, M_PI / 2, 0, 0}, {1, 3, 0.5F});
    EXPECT_NEAR(flat.intersect({0, 0, 0}, {1, 0, 0}).value(), 2, 1e-5F) << "y axis along -x";
}

TEST(Solid, NormalsPointOutwards)
{
    const auto isNear = [](const Vector3& a, const Vector3& b) { return (a - b).norm() < 1e-5F; };
    const Solid box = at(Shape::Box, {5, 0, 0, M_PI / 2, 0, 0}, {1, 2, 3});
    EXPECT_TRUE(isNear(box.normalAt({1, 0.3F, 0.2F}), {0, 1, 0}));  // its x axis is the world's y
    EXPECT_TRUE(isNear(box.normalAt({0.2F, 0.3F, -3}), {0, 0, -1}));
    const Solid cylinder = at(Shape::Cylinder, {0, 0, 0, 0, 0, 0}, {2, 2, 1});
    EXPECT_TRUE(isNear(cylinder.normalAt({1.2F, 1.6F, 0.1F}), {0.6F, 0.8F, 0}));
    EXPECT_TRUE(isNear(cylinder.normalAt({1, 0, 1}), {0, 0, 1}));
    const Solid ball = at(Shape::Ellipsoid, {0, 0, 0, 0, 0, 0}, {2, 2, 2});
    EXPECT_TRUE(isNear(ball.normalAt({0, 1.2F, 1.6F}), {0, 0.6F, 0.8F}));
}

TEST(Solid, KnowsWhatIsInside)
{
    const Solid box = at(Shape::Box, {5, 0, 0, M_PI / 4, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(box.contains({6.3F, 0, 0}));
    EXPECT_FALSE(box.contains({6.3F, 0.3F, 0}));
    EXPECT_FALSE(box.contains({6.3F, 0, 0}, 0.2F)) << "not that deep";
    const Solid cylinder = at(Shape::Cylinder, {0, 0, 0, 0, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(cylinder.contains({0.7F, 0.7F, 0.9F}));
    EXPECT_FALSE(cylinder.contains({0.75F, 0.75F, 0}));
    EXPECT_FALSE(at(Shape::Ellipsoid, {}, {1, 1, 1}).contains({0.7F, 0.7F, 0.7F}));
}

class SurfaceSamples : public ::testing::TestWithParam<Shape>
{
};

TEST_P(SurfaceSamples, CoverTheWholeSurfaceAndNothingElse)
{
    constexpr float SPACING = 0.05F;
    const Solid solid = at(GetParam(), {1, 2, 3, 0.3, 0.2, 0.1}, {0.2F, 0.3F, 0.4F});
    const auto samples = solid.sampleSurface(SPACING);
    for (const auto& s : samples) {
        EXPECT_TRUE(solid.contains(s.position - s.normal * 1e-3F));
        EXPECT_FALSE(solid.contains(s.position + s.normal * 1e-3F));
        EXPECT_NEAR(s.normal.norm(), 1, 1e-5F);
    }
    // Wherever a ray from outside enters there is a sample nearby.
    const Vector3 center{1, 2, 3};
    for (int i = 0; i < 500; ++i) {
        const float a = 2.39996F * static_cast<float>(i);  // Fibonacci sphere of directions
        const float z = (static_cast<float>(i) + 0.5F) / 250 - 1, r = std::sqrt(1 - z * z);
        const Vector3 from = center + Vector3{r * std::cos(a), r * std::sin(a), z} * 2.0F;
        const Vector3 hit = from + (center - from) * solid.intersect(from, center - from).value();
        float nearest = std::numeric_limits<float>::max();
        for (const auto& s : samples) nearest = std::min(nearest, (s.position - hit).norm());
        EXPECT_LT(nearest, SPACING);
    }
}

INSTANTIATE_TEST_SUITE_P(AllShapes, SurfaceSamples,
                         ::testing::Values(Shape::Box, Shape::Cylinder, Shape::Ellipsoid));
