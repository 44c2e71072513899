// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/Apartment.h"
#include "simulation/TrueSurfaces.h"
#include "support/TestFiles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

using namespace voxeland::simulation;

namespace
{
class GroundTruthOfARoom : public ::testing::Test
{
 protected:
    static CameraOptions smallImage()
    {
        CameraOptions options;
        options.width = 320;
        options.height = 240;
        return options;
    }

    GroundTruthOfARoom() { m_truth.see(SceneRenderer(m_scene, m_camera).render(m_pose), m_pose); }

    Scene m_scene = makeApartment({}, Random(5));
    RenderCamera m_camera{smallImage()};
    mrpt::math::TPose3D m_pose{2.5, 2.2, 1.5, 1.6, 0.4, 0};
    TrueSurfaces m_truth{m_scene, m_camera, 0.03F, 4};
};
}  // namespace

TEST_F(GroundTruthOfARoom, PointsLieOnTheSurfaceOfTheirObject)
{
    for (size_t i = 0; i < m_truth.points().size(); i += 17) {
        const auto& point = m_truth.points()[i];
        const Vector3 &p = point.surface.position, &n = point.surface.normal;
        bool on = false;
        for (const auto& part : m_scene.parts())
            on |= part.object == point.object && part.solid.contains(p - n * 1e-3F) &&
                  !part.solid.contains(p + n * 1e-3F);
        ASSERT_TRUE(on);
    }
}

TEST_F(GroundTruthOfARoom, OnlyWhatTheCameraSawIsSeen)
{
    const CameraFrame frame(m_pose);
    int seen = 0, blocked = 0;
    for (const auto& point : m_truth.points()) {
        if (!point.seen) continue;
        ++seen;
        const Vector3 ray = point.surface.position - frame.origin;
        EXPECT_LE(ray.norm(), 4.0F);
        if (seen % 11 != 0) continue;
        // Nothing in between: the first surface on the way is the point's, at t = 1.
        for (const auto& part : m_scene.parts()) {
            const auto t = part.solid.intersect(frame.origin, ray);
            if (t && ray.norm() * (1 - *t) > 0.05F) {
                ++blocked;
                break;
            }
        }
    }
    EXPECT_GT(seen, 3000);
    // Half a pixel beside an edge a point is taken for seen though it is just hidden.
    EXPECT_LT(blocked, seen / 11 / 50);
}

TEST_F(GroundTruthOfARoom, AllThatTheImageShowsNearbyIsSeen)
{
    std::set<ObjectId> seen;
    for (const auto& point : m_truth.points())
        if (point.seen) seen.insert(point.object);
    const auto view = SceneRenderer(m_scene, m_camera).render(m_pose);
    std::vector<int> pixels(m_scene.objects().size() + 1, 0);
    for (size_t i = 0; i < view.objects.size(); ++i)
        if (view.depth[i] < 3) ++pixels[view.objects[i]];
    for (size_t id = 0; id < pixels.size(); ++id)
        if (pixels[id] > 100) {
            EXPECT_EQ(seen.count(static_cast<ObjectId>(id)), 1U) << id;
        }
}

TEST_F(GroundTruthOfARoom, FilesHoldTheSeenPoints)
{
    const voxeland::test::TemporaryFolder folder;
    m_truth.save(folder.path().string());
    const std::string ply = voxeland::test::readFile(folder.path() / "ground_truth.ply");
    const std::string end = "end_header\n";
    const size_t body = ply.find(end) + end.size();
    size_t seen = 0;
    for (const auto& point : m_truth.points()) {
        if (!point.seen) continue;
        float x = 0;
        int32_t instance = -1;
        std::memcpy(&x, ply.data() + body + 20 * seen, 4);
        std::memcpy(&instance, ply.data() + body + 20 * seen + 12, 4);
        ASSERT_EQ(x, point.surface.position.x);
        ASSERT_EQ(instance, point.object);
        ++seen;
    }
    EXPECT_EQ(ply.size(), body + 20 * seen);
    EXPECT_NE(ply.find("element vertex " + std::to_string(seen) + "\n"), std::string::npos);

    const std::string names = voxeland::test::readFile(folder.path() / "categories.csv");
    EXPECT_EQ(names.rfind("index,name\n0,structure\n1,", 0), 0U);
    EXPECT_NE(names.find(",dining table\n"), std::string::npos);
    const std::string objects = voxeland::test::readFile(folder.path() / "objects.csv");
    EXPECT_EQ(objects.rfind("id,category,x,y,z,size_x,size_y,size_z,points\n1,", 0), 0U);
}
