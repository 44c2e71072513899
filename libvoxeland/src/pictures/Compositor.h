// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Colors.h"
#include "VoxelRaster.h"

namespace voxeland
{
/** Pixels drawn for one of a picture, along each side. */
inline constexpr int OVERSAMPLING = 2;

/** What a camera sees of a scene: the objects, and everything else. */
struct Sight
{
    Sight(const VoxelScene& scene, const ViewCamera& c, cv::Size image)
        : camera(c), objects(scene, c, image, true), background(scene, c, image, false)
    {
    }
    ViewCamera camera;
    VoxelRaster objects, background;
};

/** Azimuth of the corner from which most of the objects is seen [rad]; tried out in small. */
double bestAzimuth(const VoxelScene& scene, cv::Size image);

/** The picture of what is seen, smaller by OVERSAMPLING; everything else in front of an object is
 * translucent. \param colors of VoxelScene::voxels() */
cv::Mat3b composite(const Sight& sight, const std::vector<Color>& colors);
}  // namespace voxeland
