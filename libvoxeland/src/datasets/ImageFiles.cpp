// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles.h"

#include "files/PictureDecoders.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/datasets/RgbdDatasetReader.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace voxeland
{
namespace
{
std::vector<char> readBytes(const std::string& file, const std::string& which)
{
    std::ifstream in;
    errno = 0;
    if (fs::is_regular_file(file)) in.open(file, std::ios::binary);
    if (in.is_open()) return {std::istreambuf_iterator<char>(in), {}};
    RefusedMemory::noteErrno();
    throw UnusableFrame(which + " cannot be opened");
}

/** A JPEG file that is cut off decodes to an image with a grey lower part: look for its end. */
bool isCutJpeg(const std::vector<char>& bytes)
{
    const auto is = [](char c, int value) { return static_cast<uint8_t>(c) == value; };
    if (bytes.size() < 4 || !is(bytes[0], 0xFF) || !is(bytes[1], 0xD8)) return false;
    constexpr std::array<char, 2> END_OF_IMAGE = {'\xFF', '\xD9'};
    return std::search(bytes.rbegin(), bytes.rend(), END_OF_IMAGE.rbegin(), END_OF_IMAGE.rend()) ==
           bytes.rend();
}
}  // namespace

cv::Mat decodeImage(const std::vector<char>& bytes, const std::string& which)
{
    const uint64_t damagedBefore = damagedPictures(), oversizedBefore = oversizedPictures();
    cv::Mat image;
    errno = 0;
    const SilentDecoders silent;
    if (!bytes.empty() && !isCutJpeg(bytes)) image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
    if (oversizedPictures() != oversizedBefore)
        throw UnusableFrame(which + " has too many pixels for the camera");
    if (image.empty()) RefusedMemory::noteErrno();
    if (image.empty() || damagedPictures() != damagedBefore)
        throw UnusableFrame(which + " is damaged");
    return image;
}

cv::Mat readImage(const std::string& file, const std::string& which)
{
    return decodeImage(readBytes(file, which), which);
}

void setDepth(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image)
{
    constexpr uint16_t TOO_FAR = 65535;
    if (image.type() != CV_16UC1)
        throw UnusableFrame("depth image is not one of 16 bits and one channel");
    scan.rangeImage_setSize(image.rows, image.cols);
    for (int r = 0; r < image.rows; ++r)
        std::replace_copy(image.ptr<uint16_t>(r), image.ptr<uint16_t>(r) + image.cols,
                          &scan.rangeImage(r, 0), TOO_FAR, uint16_t{0});
    scan.hasRangeImage = true;
}

void setColour(mrpt::obs::CObservation3DRangeScan& scan, const cv::Mat& image)
{
    if (image.depth() != CV_8U) throw UnusableFrame("colour image is not one of 8 bits a channel");
    scan.intensityImage = mrpt::img::CImage(image, mrpt::img::SHALLOW_COPY);
    scan.hasIntensityImage = true;
}

RgbdRecord readImages(const fs::path& colour, const fs::path& depth)
{
    if (!fs::exists(colour)) throw UnusableFrame("no colour image");
    if (!fs::exists(depth)) throw UnusableFrame("no depth image");
    RgbdRecord record;
    record.scan = mrpt::obs::CObservation3DRangeScan::Create();
    setDepth(*record.scan, readImage(depth.string(), "depth image"));
    setColour(*record.scan, readImage(colour.string(), "colour image"));
    record.scan->intensityImage.setExternalStorage(fs::absolute(colour).string());
    return record;
}
}  // namespace voxeland
