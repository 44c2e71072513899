// SPDX-License-Identifier: BSD-3-Clause
#include "Letterbox.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace voxeland
{
Letterbox::Letterbox(const cv::Size& image, const cv::Size& input)
    : m_image(image),
      m_input(input),
      m_scale(std::min(static_cast<double>(input.width) / image.width,
                       static_cast<double>(input.height) / image.height))
{
    const auto scaled = [this](int length) {
        return std::max(1, static_cast<int>(std::lround(length * m_scale)));
    };
    m_content.width = scaled(image.width);
    m_content.height = scaled(image.height);
    m_content.x = (input.width - m_content.width) / 2;
    m_content.y = (input.height - m_content.height) / 2;
}

cv::Mat Letterbox::fill(const cv::Mat& image) const
{
    constexpr double GREY = 114;  // what Ultralytics trains with
    cv::Mat input(m_input, image.type(), cv::Scalar::all(GREY));
    cv::Mat content = input(m_content);
    cv::resize(image, content, m_content.size(), 0, 0, cv::INTER_LINEAR);
    return input;
}

cv::Rect2d Letterbox::toImage(const cv::Rect2d& box) const
{
    const cv::Point2d origin = m_content.tl();
    const cv::Rect2d unscaled((box.tl() - origin) / m_scale, (box.br() - origin) / m_scale);
    return unscaled & cv::Rect2d({0, 0}, cv::Size2d(m_image));
}
}  // namespace voxeland
