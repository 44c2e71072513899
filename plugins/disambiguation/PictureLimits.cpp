// SPDX-License-Identifier: BSD-3-Clause
#include "PictureLimits.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace voxeland
{
namespace
{
std::string asJpeg(const cv::Mat& image)
{
    constexpr int QUALITY = 90;
    std::vector<uchar> file;
    cv::imencode(".jpg", image, file, {cv::IMWRITE_JPEG_QUALITY, QUALITY});
    return {file.begin(), file.end()};
}

cv::Mat shrunk(const cv::Mat& image, double factor)
{
    cv::Mat result;
    const auto length = [factor](int old) { return std::max(1, cvRound(old * factor)); };
    cv::resize(image, result, {length(image.cols), length(image.rows)}, 0, 0, cv::INTER_AREA);
    return result;
}
}  // namespace

DisambiguationPicture fitted(const DisambiguationPicture& picture, const PictureLimits& limits)
{
    cv::Mat image;
    if (!picture.bytes.empty())
        image = cv::imdecode(std::vector<uchar>(picture.bytes.begin(), picture.bytes.end()),
                             cv::IMREAD_COLOR);
    if (image.empty())
        throw DisambiguationError("picture '" + picture.caption + "' cannot be decoded", false);
    const auto side = static_cast<double>(std::max(image.cols, image.rows));
    if (side <= limits.side && picture.bytes.size() <= limits.bytes) return picture;

    if (side > limits.side) image = shrunk(image, limits.side / side);
    DisambiguationPicture result{picture.caption, "image/jpeg", asJpeg(image)};
    while (result.bytes.size() > limits.bytes && std::max(image.cols, image.rows) > 1) {
        image = shrunk(image, 0.8);
        result.bytes = asJpeg(image);
    }
    return result;
}
}  // namespace voxeland
