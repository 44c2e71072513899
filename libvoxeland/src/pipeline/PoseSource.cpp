// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/pipeline/PoseSource.h"

namespace voxeland
{
std::string problemOfPoseSource(const std::string& source)
{
    for (const char* word : {"robot_pose", "odometry", "actions", "simplemap"})
        if (source == word) return "";
    const std::string tum = TUM_POSES;
    if (source.rfind(tum, 0) == 0 && source != tum) return "";
    return "[voxeland] pose_source = '" + source +
           "' is not one of robot_pose, odometry, actions, simplemap, tum:<file>";
}
}  // namespace voxeland
