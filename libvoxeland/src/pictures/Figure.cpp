// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"

#include "base/ClassicNumbers.h"

#include <mrpt/core/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
// Layout of a page 1000 pixels high and 1500 wide.
constexpr int TITLE = 60, LEGEND_LEFT = 1100, LEGEND_TOP = 80, LEGEND_BOTTOM = 860,
              COLUMN_WIDTH = 200, ROW_HEIGHT = 26, SWATCH = 18, BAR_HEIGHT = 400;
const cv::Scalar BLACK(30, 30, 30), WHITE(255, 255, 255);

int scaled(double unit, double x)
{
    return static_cast<int>(std::lround(unit * x));
}

cv::Scalar bgr(const Color& c)
{
    return {static_cast<double>(c.blue), static_cast<double>(c.green), static_cast<double>(c.red)};
}
}  // namespace

Figure::Figure(int height)
    : m_image(height, height * 3 / 2, cv::Vec3b(255, 255, 255)), m_unit(height / 1000.0)
{
}

cv::Size Figure::pictureSize(int height)
{
    return {scaled(height / 1000.0, LEGEND_LEFT - 20), height - scaled(height / 1000.0, TITLE)};
}

void Figure::write(const std::string& text, cv::Point baseline, double size, bool halo)
{
    const double scale = 0.5 * size * m_unit;
    const int thickness = std::max(1, scaled(m_unit, size));
    const auto put = [&](const cv::Scalar& color, int width) {
        cv::putText(m_image, text, baseline, cv::FONT_HERSHEY_SIMPLEX, scale, color, width,
                    cv::LINE_AA);
    };
    if (halo) put(WHITE, thickness + 3);
    put(BLACK, thickness);
}

void Figure::drawTitle(const std::string& text)
{
    write(text, {scaled(m_unit, 20), scaled(m_unit, 40)}, 1.6);
}

void Figure::drawPicture(const cv::Mat3b& picture)
{
    picture.copyTo(m_image(cv::Rect({0, scaled(m_unit, TITLE)}, picture.size())));
}

void Figure::drawLabels(const std::vector<ViewColoring::Label>& labels, const ViewCamera& camera)
{
    const int height = scaled(m_unit, 16);
    std::vector<cv::Rect> written;
    for (const auto& label : labels) {
        const cv::Vec3f at = camera.project(label.position);
        const int width = scaled(m_unit, 10 * static_cast<double>(label.text.size()));
        const cv::Rect place(static_cast<int>(at[0]) - width / 2,
                             static_cast<int>(at[1]) + scaled(m_unit, TITLE) - height / 2, width,
                             height);
        const auto covers = [&](const cv::Rect& other) { return !(place & other).empty(); };
        if (std::any_of(written.begin(), written.end(), covers)) continue;
        written.push_back(place);
        write(label.text, {place.x, place.y + scaled(m_unit, 13)}, 1, true);
    }
}

void Figure::drawScale(float pixelsPerMetre)
{
    double metres = 0.01;
    for (const double m : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        if (m * static_cast<double>(pixelsPerMetre) < 250 * m_unit) metres = m;
    const cv::Point left(scaled(m_unit, 30), scaled(m_unit, 970));
    const cv::Point right =
        left + cv::Point(static_cast<int>(metres * static_cast<double>(pixelsPerMetre)), 0);
    cv::line(m_image, left, right, WHITE, scaled(m_unit, 9));
    cv::line(m_image, left, right, BLACK, scaled(m_unit, 5));
    write(format("%g m", metres), left - cv::Point(0, scaled(m_unit, 10)), 1.1, true);
}

void Figure::drawAxes(const VoxelScene& scene, const ViewCamera& camera)
{
    const cv::Point origin(scaled(m_unit, 1410), scaled(m_unit, 930));
    const float length = static_cast<float>(45 * m_unit);
    for (size_t a = 0; a < 3; ++a) {
        const cv::Point2f d = camera.inImage(scene.mapAxes()[a]);
        if (cv::norm(d) < 0.2) continue;  // along the direction of view
        const cv::Scalar color(a == 2 ? 200 : 0, a == 1 ? 150 : 0, a == 0 ? 200 : 0);
        cv::arrowedLine(m_image, origin, origin + cv::Point(d * length), color,
                        std::max(1, scaled(m_unit, 2)), cv::LINE_AA);
        write(std::string(1, "xyz"[a]), origin + cv::Point(d * (length * 1.3F)), 1, true);
    }
}

int Figure::drawBar(double maximum, int row)
{
    const int left = scaled(m_unit, LEGEND_LEFT), width = scaled(m_unit, 40),
              height = scaled(m_unit, BAR_HEIGHT);
    for (int i = 0; i < height; ++i)
        cv::line(m_image, {left, row + i}, {left + width, row + i},
                 bgr(uncertaintyColor(1 - static_cast<double>(i) / height)));
    constexpr int TICKS = 4;
    for (int i = 0; i <= TICKS; ++i) {
        const double share = static_cast<double>(i) / TICKS;
        const std::string text = format("%s%.2f nat", i == TICKS ? ">= " : "", share * maximum);
        write(text, {left + width + scaled(m_unit, 10),
                     row + scaled(m_unit, 6) + static_cast<int>((1 - share) * height)});
    }
    return row + height + scaled(m_unit, 40);
}

void Figure::drawLegend(const ViewColoring& coloring)
{
    int row = scaled(m_unit, LEGEND_TOP);
    if (coloring.barMaximum > 0) row = drawBar(coloring.barMaximum, row);

    const int rowHeight = scaled(m_unit, ROW_HEIGHT), swatch = scaled(m_unit, SWATCH);
    const auto perColumn =
        static_cast<size_t>(std::max(1, (scaled(m_unit, LEGEND_BOTTOM) - row) / rowHeight));
    const size_t room = 2 * perColumn;
    const auto& entries = coloring.legend;
    const bool tooMany = entries.size() > room;
    const size_t shown = tooMany ? room - 1 : entries.size();
    const auto placeOf = [&](size_t i) {
        return cv::Point(
            scaled(m_unit, LEGEND_LEFT + COLUMN_WIDTH * static_cast<int>(i / perColumn)),
            row + static_cast<int>(i % perColumn) * rowHeight);
    };
    const cv::Point toText(swatch + scaled(m_unit, 8), swatch - scaled(m_unit, 4));
    for (size_t i = 0; i < shown; ++i) {
        const cv::Rect box(placeOf(i), cv::Size(swatch, swatch));
        cv::rectangle(m_image, box, bgr(entries[i].color), cv::FILLED);
        cv::rectangle(m_image, box, BLACK, 1);
        write(entries[i].text, placeOf(i) + toText, 0.9);
    }
    if (tooMany)
        write(format("and %zu more", entries.size() - shown), placeOf(shown) + toText, 0.9);
}
}  // namespace voxeland
