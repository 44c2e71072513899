// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** Pinhole camera [pixels], with lens distortion by the plumb-bob model of OpenCV and MRPT. */
struct PinholeCamera
{
    double fx = 0, fy = 0, cx = 0, cy = 0;
    std::array<double, 5> distortion{};  //!< k1 k2 p1 p2 k3
};

/** What a dataset says of the two cameras that took its frames, both at the same place. */
struct DatasetCameras
{
    PinholeCamera depth, colour;
    bool registered = true;    //!< both images show the same, pixel by pixel
    double depthScale = 1000;  //!< numbers in a depth image that make a metre
};

/** Cameras with registered images. */
DatasetCameras registeredCameras(const PinholeCamera& camera, double depthScale);

/** Calibrates a scan whose images are loaded. Its depth camera is at the robot's origin.
 *  \param frame name of the frame, for messages
 *  \throws InputError if the centre of a camera is not in its image, or if registered images differ
 *  in size */
void calibrate(mrpt::obs::CObservation3DRangeScan& scan, const DatasetCameras& cameras,
               const std::string& frame);
}  // namespace voxeland
