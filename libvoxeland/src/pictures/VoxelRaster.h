// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "ViewCamera.h"

namespace voxeland
{
/** Which voxel is seen in each pixel of a picture, how far and how bright; colours come later. */
class VoxelRaster
{
 public:
    static constexpr int NOTHING = -1;

    /** Draws the objects, or everything else, of a scene into an image of this size. */
    VoxelRaster(const VoxelScene& scene, const ViewCamera& camera, cv::Size image, bool objects);

    /** Index in VoxelScene::voxels(), or NOTHING. */
    [[nodiscard]] const cv::Mat_<int>& voxel() const { return m_voxel; }
    /** Distance along the direction of view [m]; infinite where there is nothing. */
    [[nodiscard]] const cv::Mat_<float>& depth() const { return m_depth; }
    /** Brightness in (0,1]: 1 for faces that look up and have nothing in front of them beside
     *  them. */
    [[nodiscard]] const cv::Mat_<float>& light() const { return m_light; }

 private:
    void drawFace(const std::array<cv::Vec3f, 4>& corners, int voxel, float light);
    void drawTriangle(const cv::Vec3f& a, const cv::Vec3f& b, const cv::Vec3f& c, int voxel,
                      float light);
    /** Darkens what lies behind its neighbours ("eye-dome lighting"), so that shapes stand out. */
    void shadeEdges(float voxelEdge);

    cv::Mat_<int> m_voxel;
    cv::Mat_<float> m_depth, m_light;
};
}  // namespace voxeland
