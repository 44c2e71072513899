// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Scene.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace voxeland::simulation
{
/** A camera's place and axes in the world. */
struct CameraFrame
{
    explicit CameraFrame(const mrpt::math::TPose3D& pose);
    Vector3 origin, forward, left, up;
};

/** Pinhole camera without distortion. The camera's frame has x forward, y left, z up; columns
 *  grow to the right, rows downwards. */
struct RenderCamera
{
    int width = 0, height = 0;        //!< [pixels]
    float focal = 0, cx = 0, cy = 0;  //!< [pixels]

    explicit RenderCamera(const CameraOptions& options);

    /** Where a point of the world is seen. */
    struct Pixel
    {
        size_t index;  //!< row * width + column
        float depth;   //!< along the optical axis [m]
    };
    /** The pixel that shows a point of the world; none if it is out of view. */
    [[nodiscard]] std::optional<Pixel> project(const CameraFrame& frame,
                                               const Vector3& point) const;

    [[nodiscard]] size_t pixels() const
    {
        return static_cast<size_t>(width) * static_cast<size_t>(height);
    }
    /** Factor from lengths in an image 640 pixels wide to lengths in this one. */
    [[nodiscard]] float scale() const { return static_cast<float>(width) / 640.0F; }
};

/** An image without any noise; all vectors are row-major. */
struct RenderedView
{
    std::vector<float> depth;       //!< along the optical axis [m]; 0 where there is nothing
    std::vector<ObjectId> objects;  //!< what each pixel shows
    std::vector<float> cosines;     //!< of the angle between the ray and the surface's normal
    std::vector<uint8_t> bgr;       //!< colour image, 3 bytes a pixel
};

/** Draws a scene: every solid is intersected exactly with the rays of the pixels it may cover. */
class SceneRenderer
{
 public:
    /** Keeps a reference to the scene. */
    SceneRenderer(const Scene& scene, const RenderCamera& camera);

    /** \param pose of the camera, x forward, z up. Safe to call from several threads. */
    [[nodiscard]] RenderedView render(const mrpt::math::TPose3D& pose) const;

 private:
    using PartIndex = uint32_t;  // as wide as a depth: both are updated in one vector operation
    static constexpr PartIndex NOTHING = 0xffffffff;

    struct Rectangle
    {
        int left, top, right, bottom;  //!< right and bottom are not part of it
    };

    [[nodiscard]] Rectangle cover(const Solid& solid, const CameraFrame& frame) const;
    template <Solid::Shape SHAPE>
    void draw(PartIndex part, const CameraFrame& frame, const Rectangle& area,
              std::vector<float>& depth, std::vector<PartIndex>& parts) const;
    [[nodiscard]] float light(const Vector3& point, const Vector3& normal) const;

    const Scene& m_scene;
    RenderCamera m_camera;
    std::vector<Vector3> m_lamps;  //!< one below each room's ceiling
};
}  // namespace voxeland::simulation
