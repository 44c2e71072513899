// SPDX-License-Identifier: BSD-3-Clause
#include "PoseSource.h"

namespace voxeland
{
bool isTumPoseSource(const std::string& source)
{
    return source.rfind(TUM_POSES, 0) == 0;
}

std::string problemOfPoseSource(const std::string& source)
{
    for (const char* word : {"robot_pose", "odometry", "actions", SIMPLEMAP_POSES})
        if (source == word) return "";
    if (isTumPoseSource(source) && source != TUM_POSES) return "";
    return "[voxeland] pose_source = '" + source +
           "' is not one of robot_pose, odometry, actions, simplemap, tum:<file>";
}
}  // namespace voxeland
