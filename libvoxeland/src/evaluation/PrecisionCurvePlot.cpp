// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluationReport.h"
#include "Plot.h"
#include "base/ClassicNumbers.h"

#include <algorithm>

namespace voxeland
{
namespace
{
void drawAxes(Plot& plot, double maxEntropy, double maxInstances)
{
    for (int i = 0; i <= 5; ++i) {
        const double y = i / 5.0;
        plot.drawLevel(y, format("%.1f", y));
        plot.write(format("%.0f", y * maxInstances), {maxEntropy, y}, {10, 6}, Plot::Align::left,
                   Plot::BLACK);
    }
    const double step = maxEntropy > 1 ? 0.2 : (maxEntropy > 0.4 ? 0.1 : 0.05);
    for (int i = 0; i * step <= maxEntropy + 1e-9; ++i)
        plot.writeBelow(i * step, format("%.2f", i * step));
    plot.drawFrame("instances with a category entropy below this [nat]");
    plot.writeAbove("precision (line)", Plot::Align::left, Plot::BLUE);
    plot.writeAbove("instances (bars)", Plot::Align::right, Plot::BLACK);
}

void drawCurve(Plot& plot, const std::vector<PrecisionAtThreshold>& curve)
{
    const PrecisionAtThreshold* last = nullptr;
    for (const PrecisionAtThreshold& p : curve) {
        if (p.instances == 0) continue;
        if (last != nullptr)
            plot.drawLine({last->threshold, last->precision()}, {p.threshold, p.precision()},
                          Plot::BLUE, 2);
        plot.drawDot({p.threshold, p.precision()}, Plot::BLUE);
        last = &p;
    }
}
}  // namespace

std::string precisionCurvePng(const std::vector<PrecisionAtThreshold>& curve,
                              const std::optional<UncertaintyThreshold>& threshold)
{
    const double maxEntropy = curve.empty() ? 1 : curve.back().threshold;
    const auto maxInstances =
        static_cast<double>(std::max<size_t>(1, curve.empty() ? 0 : curve.back().instances));
    Plot plot(maxEntropy, 1);
    double previous = 0;
    for (const PrecisionAtThreshold& p : curve) {
        plot.drawBar(previous, p.threshold, static_cast<double>(p.instances) / maxInstances);
        previous = p.threshold;
    }
    drawAxes(plot, maxEntropy, maxInstances);
    drawCurve(plot, curve);
    if (threshold && threshold->value <= maxEntropy) {
        plot.drawLine({threshold->value, 0}, {threshold->value, 1}, Plot::RED, 1);
        plot.write("suggested " + format("%.2f", threshold->value), {threshold->value, 1}, {0, -8},
                   Plot::Align::center, Plot::RED);
    }
    return plot.png();
}
}  // namespace voxeland
