// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluationReport.h"
#include "Plot.h"
#include "base/ClassicNumbers.h"

namespace voxeland
{
namespace
{
void drawDiagram(Plot& plot, const std::vector<ReliabilityBin>& diagram, const cv::Scalar& color)
{
    const ReliabilityBin* last = nullptr;
    for (const ReliabilityBin& bin : diagram) {
        if (last != nullptr)
            plot.drawLine({last->probability, last->correct}, {bin.probability, bin.correct}, color,
                          2);
        plot.drawDot({bin.probability, bin.correct}, color);
        last = &bin;
    }
}
}  // namespace

std::string reliabilityPng(const UncertaintyMetrics& uncertainty)
{
    Plot plot(1, 1);
    for (int i = 0; i <= 5; ++i) {
        plot.drawLevel(i / 5.0, format("%.1f", i / 5.0));
        plot.writeBelow(i / 5.0, format("%.1f", i / 5.0));
    }
    plot.drawFrame("probability that the map gives (bins of equally many); right on the diagonal");
    plot.drawLine({0, 0}, {1, 1}, Plot::BLACK, 1);
    drawDiagram(plot, uncertainty.pointConfidence.diagram, Plot::RED);
    drawDiagram(plot, uncertainty.confidence.diagram, Plot::BLUE);
    plot.writeAbove("share that is right: categories of instances", Plot::Align::left, Plot::BLUE);
    plot.writeAbove("instances of points", Plot::Align::right, Plot::RED);
    return plot.png();
}
}  // namespace voxeland
