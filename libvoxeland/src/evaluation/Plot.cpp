// SPDX-License-Identifier: BSD-3-Clause
#include "Plot.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace voxeland
{
namespace
{
const cv::Rect AXES(90, 50, 760, 420);
const cv::Size PICTURE(940, 560);
}  // namespace

const cv::Scalar Plot::BLACK(0, 0, 0), Plot::GRID(225, 225, 225), Plot::BLUE(180, 90, 20),
    Plot::BARS(215, 225, 235), Plot::RED(40, 40, 200);

Plot::Plot(double right, double top)
    : m_image(PICTURE, CV_8UC3, cv::Scalar::all(255)), m_right(right), m_top(top)
{
}

void Plot::drawLevel(double y, const std::string& words)
{
    drawLine({0, y}, {m_right, y}, GRID, 1);
    write(words, {0, y}, {-12, 6}, Align::right, BLACK);
}

void Plot::writeBelow(double x, const std::string& words)
{
    write(words, {x, 0}, {0, 24}, Align::center, BLACK);
}

void Plot::drawFrame(const std::string& abscissa)
{
    cv::rectangle(m_image, AXES, BLACK, 1, cv::LINE_AA);
    write(abscissa, {m_right / 2, 0}, {0, 54}, Align::center, BLACK);
}

void Plot::drawBar(double from, double to, double height)
{
    cv::rectangle(m_image, at({from, height}), at({to, 0}), BARS, cv::FILLED);
}

void Plot::drawLine(const cv::Point2d& from, const cv::Point2d& to, const cv::Scalar& color,
                    int width)
{
    cv::line(m_image, at(from), at(to), color, width, cv::LINE_AA);
}

void Plot::drawDot(const cv::Point2d& place, const cv::Scalar& color)
{
    cv::circle(m_image, at(place), 3, color, cv::FILLED, cv::LINE_AA);
}

void Plot::write(const std::string& words, const cv::Point2d& place, const cv::Point& offset,
                 Align align, const cv::Scalar& color)
{
    writeAt(words, at(place) + offset, align, color);
}

void Plot::writeAbove(const std::string& words, Align align, const cv::Scalar& color)
{
    writeAt(words, {align == Align::right ? PICTURE.width - 12 : 12, 30}, align, color);
}

std::string Plot::png() const
{
    std::vector<unsigned char> bytes;
    cv::imencode(".png", m_image, bytes);
    return {bytes.begin(), bytes.end()};
}

cv::Point Plot::at(const cv::Point2d& place) const
{
    return {AXES.x + static_cast<int>(std::lround(place.x / m_right * AXES.width)),
            AXES.y + static_cast<int>(std::lround((1 - place.y / m_top) * AXES.height))};
}

void Plot::writeAt(const std::string& words, cv::Point position, Align align,
                   const cv::Scalar& color)
{
    constexpr double SCALE = 0.55;
    const int width = cv::getTextSize(words, cv::FONT_HERSHEY_SIMPLEX, SCALE, 1, nullptr).width;
    if (align == Align::center) position.x -= width / 2;
    if (align == Align::right) position.x -= width;
    cv::putText(m_image, words, position, cv::FONT_HERSHEY_SIMPLEX, SCALE, color, 1, cv::LINE_AA);
}
}  // namespace voxeland
