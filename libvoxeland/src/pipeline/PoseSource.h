// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** What InputOptions::pose_source begins with where it names a trajectory in TUM format. */
inline constexpr const char* TUM_POSES = "tum:";

/** The InputOptions::pose_source that stands for the poses of a simplemap's keyframes. */
inline constexpr const char* SIMPLEMAP_POSES = "simplemap";

/** Whether an InputOptions::pose_source names a trajectory in TUM format. */
bool isTumPoseSource(const std::string& source);

/** What is wrong with an InputOptions::pose_source, as a sentence; empty if nothing is. */
std::string problemOfPoseSource(const std::string& source);
}  // namespace voxeland
