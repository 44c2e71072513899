// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland
{
namespace
{
constexpr float MARGIN = 0.95F;                 //!< share of the image the scene may fill
constexpr double ELEVATION = 50 * CV_PI / 180;  //!< of the perspective's eye [rad]
constexpr double DISTANCE = 1.4;                //!< of the eye, in diagonals of the scene

cv::Point2f middleOf(cv::Size image)
{
    return {static_cast<float>(image.width) / 2, static_cast<float>(image.height) / 2};
}
}  // namespace

ViewCamera ViewCamera::top(const VoxelScene& scene, cv::Size image)
{
    ViewCamera camera;
    camera.m_right = {1, 0, 0};
    camera.m_down = {0, -1, 0};
    camera.m_forward = {0, 0, -1};
    camera.m_middle = (scene.min() + scene.max()) * 0.5F;
    camera.fit(scene, image);
    return camera;
}

ViewCamera ViewCamera::perspective(const VoxelScene& scene, cv::Size image, double azimuth)
{
    const auto ca = static_cast<float>(std::cos(azimuth)),
               sa = static_cast<float>(std::sin(azimuth)),
               ce = static_cast<float>(std::cos(ELEVATION)),
               se = static_cast<float>(std::sin(ELEVATION));
    ViewCamera camera;
    camera.m_forward = {-ca * ce, -sa * ce, -se};
    camera.m_right = {-sa, ca, 0};
    camera.m_down = camera.m_forward.cross(camera.m_right);
    camera.m_middle = (scene.min() + scene.max()) * 0.5F;
    camera.m_distance = static_cast<float>(DISTANCE * cv::norm(scene.max() - scene.min()));
    camera.m_eye = camera.m_middle - camera.m_forward * camera.m_distance;
    camera.fit(scene, image);
    return camera;
}

void ViewCamera::fit(const VoxelScene& scene, cv::Size image)
{
    constexpr float INF = std::numeric_limits<float>::infinity();
    const auto edge = static_cast<float>(scene.resolution());
    cv::Point2f low(INF, INF), high(-INF, -INF);
    for (const SceneVoxel& v : scene.voxels()) {
        cv::Vec3f p = v.center;
        for (int a = 0; a < 3; ++a) p[a] = std::clamp(p[a], scene.min()[a], scene.max()[a]);
        const cv::Vec3f at = project(p);
        low = {std::min(low.x, at[0] - edge), std::min(low.y, at[1] - edge)};
        high = {std::max(high.x, at[0] + edge), std::max(high.y, at[1] + edge)};
    }
    m_center = middleOf(image);
    if (scene.voxels().empty()) return;
    m_scale = MARGIN * std::min(static_cast<float>(image.width) / (high.x - low.x),
                                static_cast<float>(image.height) / (high.y - low.y));
    m_center -= (low + high) * (m_scale / 2);
}

cv::Vec3f ViewCamera::project(const cv::Vec3f& point) const
{
    const cv::Vec3f d = point - m_middle;
    const float depth = d.dot(m_forward) + m_distance;
    const float scale = m_eye ? m_scale * m_distance / depth : m_scale;
    return {m_center.x + scale * d.dot(m_right), m_center.y + scale * d.dot(m_down), depth};
}
}  // namespace voxeland
