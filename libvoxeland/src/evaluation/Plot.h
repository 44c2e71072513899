// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <opencv2/core.hpp>

#include <string>

namespace voxeland
{
/** A diagram while it is drawn: a frame whose lower left corner is (0, 0). */
class Plot
{
 public:
    enum class Align
    {
        left,
        center,
        right
    };

    static const cv::Scalar BLACK, GRID, BLUE, BARS, RED;

    /** \param right, top what is at the upper right corner */
    Plot(double right, double top);

    /** A horizontal line of the grid, with words at its left end. */
    void drawLevel(double y, const std::string& words);
    /** Words below the frame. */
    void writeBelow(double x, const std::string& words);
    /** The frame, and what its abscissa is. */
    void drawFrame(const std::string& abscissa);
    void drawBar(double from, double to, double height);
    void drawLine(const cv::Point2d& from, const cv::Point2d& to, const cv::Scalar& color,
                  int width);
    void drawDot(const cv::Point2d& place, const cv::Scalar& color);
    /** \param offset of the words from the place [pixels] */
    void write(const std::string& words, const cv::Point2d& place, const cv::Point& offset,
               Align align, const cv::Scalar& color);
    /** Words above the frame, at its left or right end. */
    void writeAbove(const std::string& words, Align align, const cv::Scalar& color);

    /** The picture as a PNG file. */
    [[nodiscard]] std::string png() const;

 private:
    [[nodiscard]] cv::Point at(const cv::Point2d& place) const;
    void writeAt(const std::string& words, cv::Point position, Align align,
                 const cv::Scalar& color);

    cv::Mat m_image;
    double m_right, m_top;
};
}  // namespace voxeland
