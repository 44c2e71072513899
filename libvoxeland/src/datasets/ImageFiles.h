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
/** Decodes an image, whole and with its own depth and channels.
 *  \param name where the bytes come from, for the message
 *  \throws InputError if it is damaged or cut off */
cv::Mat decodeImage(const std::vector<char>& bytes, const std::string& name);

/** Reads an image file as decodeImage() does. */
cv::Mat readImage(const std::string& file);

/** Sets the range image from one of 16 bits; 65535, some sensors' "too far", becomes 0.
 *  \throws InputError, with this name, if it is something else */
void setDepth(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image,
              const std::string& name);

/** Sets the colour image. \throws InputError, with this name, unless it has 8 bits a channel */
void setColour(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image,
               const std::string& name);

/** A record with a scan of images read from files; it remembers where colour came from
 *  (isExternallyStored()). \throws UnusableFrame if a file is missing, InputError, naming the file,
 *  if it is damaged or something else */
RgbdRecord readImages(const std::filesystem::path& colour, const std::filesystem::path& depth);
}  // namespace voxeland
