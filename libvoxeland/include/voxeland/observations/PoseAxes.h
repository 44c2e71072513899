// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/poses/CPose3D.h>

namespace voxeland
{
/** Whose poses a trajectory tells, and the axes of that. */
enum class PoseAxes
{
    body,     //!< the robot's: x forward, y left, z up
    optical,  //!< the depth camera's: x right, y down, z forward (TUM, ORB-SLAM, OpenCV)
    opengl    //!< the depth camera's: x right, y up, z backward (OpenGL, Blender, NeRF)
};

/** Pose of such axes in a sensor with MRPT's axes (x forward, y left, z up). */
mrpt::poses::CPose3D poseOfAxes(PoseAxes axes);
}  // namespace voxeland
