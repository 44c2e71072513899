// SPDX-License-Identifier: BSD-3-Clause
#include "ImageFiles.h"

#include "voxeland/errors.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace voxeland
{
namespace
{
std::vector<char> readBytes(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError("cannot open the image " + file);
    return {std::istreambuf_iterator<char>(in), {}};
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

cv::Mat decode(const std::string& file)
{
    const auto bytes = readBytes(file);
    cv::Mat image;
    if (!bytes.empty() && !isCutJpeg(bytes)) image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
    if (image.empty()) throw InputError("the image " + file + " is damaged and cannot be decoded");
    return image;
}
}  // namespace

void loadDepth(mrpt::obs::CObservation3DRangeScan& scan, const std::string& file)
{
    constexpr uint16_t TOO_FAR = 65535;
    const cv::Mat image = decode(file);
    if (image.type() != CV_16UC1)
        throw InputError("the depth image " + file + " is not one of 16 bits and one channel");
    scan.rangeImage_setSize(image.rows, image.cols);
    for (int r = 0; r < image.rows; ++r)
        std::replace_copy(image.ptr<uint16_t>(r), image.ptr<uint16_t>(r) + image.cols,
                          &scan.rangeImage(r, 0), TOO_FAR, uint16_t{0});
    scan.hasRangeImage = true;
}

void loadColour(mrpt::obs::CObservation3DRangeScan& scan, const std::string& file)
{
    const cv::Mat image = decode(file);
    if (image.depth() != CV_8U)
        throw InputError("the colour image " + file + " is not one of 8 bits a channel");
    scan.intensityImage = mrpt::img::CImage(image, mrpt::img::SHALLOW_COPY);
    scan.intensityImage.setExternalStorage(std::filesystem::absolute(file).string());
    scan.hasIntensityImage = true;
}
}  // namespace voxeland
