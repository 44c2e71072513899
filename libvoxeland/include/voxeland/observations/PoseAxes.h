// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <utility>
#include <vector>

namespace voxeland
{
/** Whose poses a trajectory tells, and the axes of that. */
enum class PoseAxes
{
    body,     //!< the robot's: x forward, y left, z up
    optical,  //!< the depth camera's: x right, y down, z forward (TUM, ORB-SLAM, OpenCV)
    opengl    //!< the depth camera's: x right, y up, z backward (OpenGL, Blender, NeRF)
};

/** All axes with their names in INI keys and options. */
const std::vector<std::pair<std::string, PoseAxes>>& poseAxesByName();

/** One of those names. */
const std::string& nameOf(PoseAxes axes);

/** The axes of a name, in any case. \param option that gives it, for the message
 *  \throws ConfigurationError, naming the option and all names, if there are none */
PoseAxes poseAxesNamed(const std::string& name, const std::string& option);

/** Pose of such axes in a sensor with MRPT's axes (x forward, y left, z up). */
mrpt::poses::CPose3D poseOfAxes(PoseAxes axes);
}  // namespace voxeland
