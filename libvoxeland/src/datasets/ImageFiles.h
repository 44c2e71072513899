// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/rawlogs/RgbdRawlogWriter.h"

#include <filesystem>
#include <string>
#include <vector>

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
/** Decodes an image of a frame, whole and with its own depth and channels.
 *  \param which of its images, for the message, e.g. "depth image"
 *  \throws UnusableFrame if it is damaged or cut off, or larger than a PictureLimit */
cv::Mat decodeImage(const std::vector<char>& bytes, const std::string& which);

/** Reads an image file as decodeImage() does. */
cv::Mat readImage(const std::string& file, const std::string& which);

/** Sets the range image from one of 16 bits; 65535, some sensors' "too far", becomes 0.
 *  \throws UnusableFrame if it is something else */
void setDepth(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image);

/** Sets the colour image. \throws UnusableFrame unless it has 8 bits a channel */
void setColour(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image);

/** A record with a scan of images read from files; it remembers where colour came from
 *  (isExternallyStored()). \throws UnusableFrame if a file is missing, damaged or something else */
RgbdRecord readImages(const std::filesystem::path& colour, const std::filesystem::path& depth);
}  // namespace voxeland
