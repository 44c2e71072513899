// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluationReport.h"
#include "base/ClassicNumbers.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace voxeland
{
namespace
{
const cv::Scalar BLACK(0, 0, 0), GRID(225, 225, 225), BLUE(180, 90, 20), BARS(215, 225, 235),
    RED(40, 40, 200);
const cv::Rect AXES(90, 50, 760, 420);
const cv::Size PICTURE(940, 560);

/** The picture while it is drawn. */
class Plot
{
 public:
    Plot(double maxEntropy, size_t maxInstances)
        : m_image(PICTURE, CV_8UC3, cv::Scalar::all(255)),
          m_maxEntropy(maxEntropy),
          m_maxInstances(static_cast<double>(std::max<size_t>(1, maxInstances)))
    {
    }

    /** How many of the instances count at each threshold: behind everything else. */
    void drawBars(const std::vector<PrecisionAtThreshold>& curve)
    {
        double previous = 0;
        for (const PrecisionAtThreshold& p : curve) {
            const double height = static_cast<double>(p.instances) / m_maxInstances;
            cv::rectangle(m_image, at(previous, height), at(p.threshold, 0), BARS, cv::FILLED);
            previous = p.threshold;
        }
    }

    void drawAxes()
    {
        for (int i = 0; i <= 5; ++i) {
            const double y = i / 5.0;
            cv::line(m_image, at(0, y), at(m_maxEntropy, y), GRID);
            write(format("%.1f", y), at(0, y) + cv::Point(-12, 6), Align::right, BLACK);
            write(format("%.0f", y * m_maxInstances), at(m_maxEntropy, y) + cv::Point(10, 6),
                  Align::left, BLACK);
        }
        const double step = m_maxEntropy > 1 ? 0.2 : (m_maxEntropy > 0.4 ? 0.1 : 0.05);
        for (int i = 0; i * step <= m_maxEntropy + 1e-9; ++i)
            write(format("%.2f", i * step), at(i * step, 0) + cv::Point(0, 24), Align::center,
                  BLACK);
        cv::rectangle(m_image, AXES, BLACK, 1, cv::LINE_AA);
        write("instances with a category entropy below this [nat]",
              at(m_maxEntropy / 2, 0) + cv::Point(0, 54), Align::center, BLACK);
        write("precision (line)", {12, 30}, Align::left, BLUE);
        write("instances (bars)", {PICTURE.width - 12, 30}, Align::right, BLACK);
    }

    void drawCurve(const std::vector<PrecisionAtThreshold>& curve)
    {
        cv::Point last;
        bool drawing = false;
        for (const PrecisionAtThreshold& p : curve) {
            if (p.instances == 0) continue;
            const cv::Point here = at(p.threshold, p.precision());
            if (drawing) cv::line(m_image, last, here, BLUE, 2, cv::LINE_AA);
            cv::circle(m_image, here, 3, BLUE, cv::FILLED, cv::LINE_AA);
            last = here;
            drawing = true;
        }
    }

    void drawThreshold(double entropy)
    {
        if (entropy > m_maxEntropy) return;
        cv::line(m_image, at(entropy, 0), at(entropy, 1), RED, 1, cv::LINE_AA);
        write("suggested " + format("%.2f", entropy), at(entropy, 1) + cv::Point(0, -8),
              Align::center, RED);
    }

    [[nodiscard]] std::string png() const
    {
        std::vector<unsigned char> bytes;
        cv::imencode(".png", m_image, bytes);
        return {bytes.begin(), bytes.end()};
    }

 private:
    enum class Align
    {
        left,
        center,
        right
    };

    [[nodiscard]] cv::Point at(double entropy, double height) const
    {
        return {AXES.x + static_cast<int>(std::lround(entropy / m_maxEntropy * AXES.width)),
                AXES.y + static_cast<int>(std::lround((1 - height) * AXES.height))};
    }

    void write(const std::string& text, cv::Point position, Align align, const cv::Scalar& color)
    {
        constexpr double SCALE = 0.55;
        const int width = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, SCALE, 1, nullptr).width;
        if (align == Align::center) position.x -= width / 2;
        if (align == Align::right) position.x -= width;
        cv::putText(m_image, text, position, cv::FONT_HERSHEY_SIMPLEX, SCALE, color, 1,
                    cv::LINE_AA);
    }

    cv::Mat m_image;
    double m_maxEntropy, m_maxInstances;
};
}  // namespace

std::string precisionCurvePng(const std::vector<PrecisionAtThreshold>& curve,
                              const std::optional<UncertaintyThreshold>& threshold)
{
    Plot plot(curve.empty() ? 1 : curve.back().threshold,
              curve.empty() ? 0 : curve.back().instances);
    plot.drawBars(curve);
    plot.drawAxes();
    plot.drawCurve(curve);
    if (threshold) plot.drawThreshold(threshold->value);
    return plot.png();
}
}  // namespace voxeland
