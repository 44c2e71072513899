// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** What InputOptions::pose_source begins with where it names a trajectory in TUM format. */
inline constexpr const char* TUM_POSES = "tum:";

/** What is wrong with an InputOptions::pose_source, as a sentence; empty if nothing is. */
std::string problemOfPoseSource(const std::string& source);
}  // namespace voxeland
