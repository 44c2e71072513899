// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cv
{
class Mat;
}
namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace voxeland
{
/** The colour image of a scan, of 8 bits, blue, green and red; read first if it is in a file, of
 * which none of more than 16 times as many pixels as the scan's camera has is decoded. \throws
 * UnusableFrame, naming the frame, if there is none or it cannot be read */
cv::Mat colourImage(const mrpt::obs::CObservation3DRangeScan& scan);
}  // namespace voxeland
