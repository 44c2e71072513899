// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/SceneRenderer.h"

#include <string>
#include <vector>

namespace voxeland::simulation
{
/** The true surfaces, as far as the camera has seen them: all a mapper could know.
 *
 *  A ground truth folder holds
 *  - `ground_truth.ply`: binary little endian; a vertex has `float x, y, z` in the world [m],
 *    `int instance` (0: walls, floor and ceiling; objects from 1) and `int category`
 *  - `categories.csv`: header `index,name`, then one line a category; index 0 is `structure`
 *  - `objects.csv`: header `id,category,x,y,z,size_x,size_y,size_z,points`; centre and size of the
 *    box along the world's axes around the whole object [m], number of its points in the PLY
 *  - `trajectory.tum`: true poses of the robot, `time x y z qx qy qz qw`, x forward, z up */
class TrueSurfaces
{
 public:
    /** A point of a surface. */
    struct Point
    {
        SurfacePoint surface;
        ObjectId object = STRUCTURE;
        bool seen = false;
    };

    /** Keeps a reference to the scene.
     *  \param spacing between neighbouring points, at most [m]
     *  \param maxRange what is farther from the camera does not count as seen [m] */
    TrueSurfaces(const Scene& scene, const RenderCamera& camera, float spacing, float maxRange);

    /** Marks the points that one view shows. */
    void see(const RenderedView& view, const mrpt::math::TPose3D& pose);

    [[nodiscard]] const std::vector<Point>& points() const { return m_points; }

    /** Writes ground_truth.ply, categories.csv and objects.csv into a folder that exists.
     *  \throws std::runtime_error if a file cannot be written */
    void save(const std::string& folder) const;

 private:
    const Scene& m_scene;
    RenderCamera m_camera;
    float m_maxRange;
    std::vector<Point> m_points;
};

/** Names of the categories in a scene, in alphabetical order after "structure", which is first. */
[[nodiscard]] std::vector<std::string> categoryNames(const Scene& scene);
}  // namespace voxeland::simulation
