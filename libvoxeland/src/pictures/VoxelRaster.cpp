// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelRaster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxeland
{
namespace
{
/** Brightness of a face by where it looks: up 1, the sides different from each other. */
float lightOf(const cv::Vec3f& normal)
{
    return 0.8F + 0.2F * normal[2] + 0.08F * normal[0] * (1 - std::abs(normal[2])) -
           0.08F * std::abs(normal[1]);
}
}  // namespace

VoxelRaster::VoxelRaster(const VoxelScene& scene, const ViewCamera& camera, cv::Size image,
                         bool objects)
    : m_voxel(image, NOTHING),
      m_depth(image, std::numeric_limits<float>::infinity()),
      m_light(image, 1.0F)
{
    const auto half = static_cast<float>(scene.resolution() / 2);
    const auto& axes = scene.mapAxes();
    for (size_t i = 0; i < scene.voxels().size(); ++i) {
        const SceneVoxel& v = scene.voxels()[i];
        if (v.isObject() != objects) continue;
        for (size_t f = 0; f < FACES.size(); ++f) {
            if ((v.exposedFaces >> f & 1U) == 0) continue;
            const cv::Vec3f normal = axes[f / 2] * (f % 2 == 0 ? -1.0F : 1.0F);
            const cv::Vec3f middle = v.center + normal * half;
            if (normal.dot(camera.rayTo(middle)) >= 0) continue;  // looks away
            const cv::Vec3f a = axes[(f / 2 + 1) % 3] * half, b = axes[(f / 2 + 2) % 3] * half;
            drawFace({camera.project(middle - a - b), camera.project(middle + a - b),
                      camera.project(middle + a + b), camera.project(middle - a + b)},
                     static_cast<int>(i), lightOf(normal));
        }
    }
    shadeEdges(2 * half);
}

void VoxelRaster::drawFace(const std::array<cv::Vec3f, 4>& corners, int voxel, float light)
{
    drawTriangle(corners[0], corners[1], corners[2], voxel, light);
    drawTriangle(corners[0], corners[2], corners[3], voxel, light);
}

void VoxelRaster::drawTriangle(const cv::Vec3f& a, const cv::Vec3f& b, const cv::Vec3f& c,
                               int voxel, float light)
{
    const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (std::abs(area) < 1e-6F) return;
    const auto first = [](float lowest) { return std::max(0, static_cast<int>(lowest)); };
    const auto last = [](float highest, int size) {
        return std::min(size - 1, static_cast<int>(std::ceil(highest)));
    };
    const int left = first(std::min({a[0], b[0], c[0]})), top = first(std::min({a[1], b[1], c[1]}));
    const int right = last(std::max({a[0], b[0], c[0]}), m_depth.cols),
              bottom = last(std::max({a[1], b[1], c[1]}), m_depth.rows);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            // Barycentric coordinates; a pixel on an edge belongs to both sides: no cracks.
            const float x = static_cast<float>(column) - a[0], y = static_cast<float>(row) - a[1];
            const float s = (x * (c[1] - a[1]) - y * (c[0] - a[0])) / area,
                        t = (y * (b[0] - a[0]) - x * (b[1] - a[1])) / area;
            if (s < 0 || t < 0 || s + t > 1) continue;
            const float depth = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
            if (depth >= m_depth(row, column)) continue;
            m_depth(row, column) = depth;
            m_voxel(row, column) = voxel;
            m_light(row, column) = light;
        }
}

void VoxelRaster::shadeEdges(float voxelEdge)
{
    constexpr int REACH = 3;
    constexpr float STRENGTH = 0.5F;
    const std::array<cv::Point, 8> around = {
        {{-REACH, 0}, {REACH, 0}, {0, -REACH}, {0, REACH}, {-2, -2}, {2, -2}, {-2, 2}, {2, 2}}};
    const cv::Rect inside(0, 0, m_depth.cols, m_depth.rows);
    for (int row = 0; row < m_depth.rows; ++row)
        for (int column = 0; column < m_depth.cols; ++column) {
            if (m_voxel(row, column) == NOTHING) continue;
            float behind = 0;  // how much deeper than its neighbours, five voxels counting full
            for (const cv::Point& d : around) {
                const cv::Point n = cv::Point(column, row) + d;
                if (!inside.contains(n)) continue;
                const float step = (m_depth(row, column) - m_depth(n)) / (5 * voxelEdge);
                behind += std::clamp(step - 0.1F, 0.0F, 1.0F);
            }
            m_light(row, column) *= 1 - STRENGTH * behind / static_cast<float>(around.size());
        }
}
}  // namespace voxeland
