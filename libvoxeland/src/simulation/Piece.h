// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Scene.h"

#include <mrpt/poses/CPose3D.h>

namespace voxeland::simulation::furniture
{
/** Builds one object out of solids given in the object's own frame. */
class Piece
{
 public:
    Piece(Scene& scene, const mrpt::poses::CPose3D& pose, const std::string& category,
          ObjectId standsOn = STRUCTURE)
        : m_scene(scene), m_pose(pose), m_id(scene.addObject(category, standsOn))
    {
    }

    /** Box by its centre and full size [m]; pitch [rad] turns it about its y axis. */
    Piece& box(const Vector3& center, const Vector3& size, const Appearance& appearance,
               double pitch = 0)
    {
        return add(Solid::Shape::Box, center, size * 0.5F, appearance, pitch);
    }
    /** Upright cylinder by its centre, radius and full height [m]. */
    Piece& cylinder(const Vector3& center, float radius, float height, const Appearance& appearance)
    {
        return add(Solid::Shape::Cylinder, center, {radius, radius, height / 2}, appearance, 0);
    }
    /** Ellipsoid by its centre and full size [m]. */
    Piece& ellipsoid(const Vector3& center, const Vector3& size, const Appearance& appearance)
    {
        return add(Solid::Shape::Ellipsoid, center, size * 0.5F, appearance, 0);
    }
    /** Four legs of square section at the corners of a rectangle around the origin [m]. */
    Piece& legs(float depth, float width, float height, float thickness,
                const Appearance& appearance)
    {
        const float x = (depth - thickness) / 2, y = (width - thickness) / 2;
        for (const float sx : {-x, x})
            for (const float sy : {-y, y})
                box({sx, sy, height / 2}, {thickness, thickness, height}, appearance);
        return *this;
    }

    [[nodiscard]] ObjectId id() const { return m_id; }

 private:
    Piece& add(Solid::Shape shape, const Vector3& center, const Vector3& halfSize,
               const Appearance& appearance, double pitch)
    {
        const auto pose = m_pose + mrpt::poses::CPose3D(center.x, center.y, center.z, 0, pitch, 0);
        m_scene.addSolid(Solid(shape, pose.asTPose(), halfSize, appearance), m_id);
        return *this;
    }

    Scene& m_scene;
    mrpt::poses::CPose3D m_pose;
    ObjectId m_id;
};
}  // namespace voxeland::simulation::furniture
