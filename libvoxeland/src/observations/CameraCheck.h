// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/img/TCamera.h>

#include <string>

namespace voxeland
{
/** What of cameras is possible: narrower or wider ones, whose rays would be parallel or reach
 *  infinity, are mistakes. */
struct CameraLimits
{
    static constexpr double NARROWEST = 1;  //!< least angle of view of either side [degrees]
    static constexpr double WIDEST =
        170;  //!< greatest, of cameras without a fisheye lens [degrees]
};

/** What is wrong with a camera, as "has a focal length of ..."; empty if nothing is. Its numbers
 * must be finite, its focal lengths positive and its angles of view within CameraLimits, its
 * principal point inside its image, and its distortion such that the middles of the image's sides
 * can be undistorted. */
std::string problemOf(const mrpt::img::TCamera& camera);
}  // namespace voxeland
