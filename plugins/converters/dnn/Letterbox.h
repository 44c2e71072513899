// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <opencv2/core.hpp>

namespace voxeland
{
/** How an image of any shape is put into a network's input: scaled as a whole, in the middle, grey
 * around it. */
class Letterbox
{
 public:
    /** \param image,input sizes [pixels], positive */
    Letterbox(const cv::Size& image, const cv::Size& input);

    [[nodiscard]] const cv::Size& image() const { return m_image; }
    [[nodiscard]] const cv::Size& input() const { return m_input; }
    /** Where the scaled image is in the input. */
    [[nodiscard]] const cv::Rect& content() const { return m_content; }

    /** The input for an image, of the same type. */
    [[nodiscard]] cv::Mat fill(const cv::Mat& image) const;
    /** A box of the input in pixels of the image, cut at its borders. */
    [[nodiscard]] cv::Rect2d toImage(const cv::Rect2d& box) const;

 private:
    cv::Size m_image, m_input;
    cv::Rect m_content;
    double m_scale;  //!< input pixels per image pixel
};
}  // namespace voxeland
