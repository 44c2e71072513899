// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "VoxelScene.h"

#include <optional>

namespace voxeland
{
/** Where a picture of a scene is taken from. */
class ViewCamera
{
 public:
    /** From above, parallel rays, to scale; x to the right, y up. */
    static ViewCamera top(const VoxelScene& scene, cv::Size image);
    /** From above a corner, looking down at the middle of the scene.
     *  \param azimuth direction from the middle to the camera, from x towards y [rad] */
    static ViewCamera perspective(const VoxelScene& scene, cv::Size image, double azimuth);

    /** Pixel column and row of a point of the gravity-aligned frame, and its depth [m]. */
    [[nodiscard]] cv::Vec3f project(const cv::Vec3f& point) const;
    /** Direction of view at a point, not normalized. */
    [[nodiscard]] cv::Vec3f rayTo(const cv::Vec3f& point) const
    {
        return m_eye ? point - *m_eye : m_forward;
    }
    /** A direction of the gravity-aligned frame as it points in the image (column, row). */
    [[nodiscard]] cv::Point2f inImage(const cv::Vec3f& direction) const
    {
        return {m_right.dot(direction), m_down.dot(direction)};
    }
    /** Pixels per metre, at the middle of the scene. */
    [[nodiscard]] float pixelsPerMetre() const { return m_scale; }

 private:
    /** Chooses scale and place so that the scene fills the image; call on a camera of scale 1. */
    void fit(const VoxelScene& scene, cv::Size image);

    cv::Vec3f m_right, m_down, m_forward, m_middle;
    std::optional<cv::Vec3f> m_eye;  //!< none: parallel rays
    cv::Point2f m_center;            //!< pixel of the middle of the scene
    float m_scale = 1;
    float m_distance = 0;  //!< from the eye to the middle [m]
};
}  // namespace voxeland
