// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/InstancePicture.h"

#include "SightPainting.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace voxeland
{
namespace
{
constexpr Color SUBJECT{235, 145, 85}, OTHER_OBJECT{150, 170, 195};

/** How much of the surroundings tells what stands in them [m]. */
double surroundingsOf(const VoxelScene& alone)
{
    const cv::Vec3f size = alone.max() - alone.min();
    return std::clamp(0.3 * static_cast<double>(std::max({size[0], size[1], size[2]})), 0.2, 0.6);
}
}  // namespace

std::string instancePicture(const SemanticVoxelMap& map, const LevelFrame& frame,
                            instance_id_t instance, int height)
{
    const VoxelScene alone(map, frame, instance, 0);
    if (alone.voxels().empty()) return {};
    const VoxelScene scene(map, frame, instance, surroundingsOf(alone));
    std::vector<Color> colors;
    for (const SceneVoxel& v : scene.voxels())
        colors.push_back(v.isObject()                                  ? SUBJECT
                         : map.winner(*v.evidence) != UNKNOWN_INSTANCE ? OTHER_OBJECT
                                                                       : UNKNOWN_COLOR);
    const cv::Size fine = cv::Size(height * 4 / 3, height) * OVERSAMPLING;
    const auto camera = ViewCamera::perspective(scene, fine, bestAzimuth(scene, fine));
    std::vector<uchar> png;
    cv::imencode(".png", paint(Sight(scene, camera, fine), colors), png);
    return {png.begin(), png.end()};
}
}  // namespace voxeland
