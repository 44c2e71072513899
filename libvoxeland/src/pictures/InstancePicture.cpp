// SPDX-License-Identifier: BSD-3-Clause
#include "InstancePicture.h"

#include "Compositor.h"

#include <opencv2/imgcodecs.hpp>

namespace voxeland
{
namespace
{
constexpr Color SUBJECT{235, 145, 85}, OTHER_OBJECT{150, 170, 195};

}  // namespace

std::string instancePicture(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                            instance_id_t instance, int height)
{
    const VoxelScene scene(map, frame, instance);
    if (scene.voxels().empty()) return {};
    std::vector<Color> colors;
    for (const SceneVoxel& v : scene.voxels())
        colors.push_back(v.isObject()                                  ? SUBJECT
                         : map.winner(*v.evidence) != UNKNOWN_INSTANCE ? OTHER_OBJECT
                                                                       : UNKNOWN_COLOR);
    const cv::Size fine = cv::Size(height * 4 / 3, height) * OVERSAMPLING;
    const auto camera = ViewCamera::perspective(scene, fine, bestAzimuth(scene, fine));
    std::vector<uchar> png;
    cv::imencode(".png", composite(Sight(scene, camera, fine), colors), png);
    return {png.begin(), png.end()};
}
}  // namespace voxeland
