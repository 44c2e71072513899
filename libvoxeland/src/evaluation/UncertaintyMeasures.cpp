// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evaluation/UncertaintyMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace voxeland
{
namespace
{
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

/** Right and wrong decisions of equal uncertainty. */
struct Tie
{
    double uncertainty = 0, right = 0, wrong = 0;
};

std::vector<Tie> tiesInOrder(std::vector<UncertainDecision>& decisions)
{
    std::sort(decisions.begin(), decisions.end(),
              [](const auto& a, const auto& b) { return a.uncertainty < b.uncertainty; });
    std::vector<Tie> ties;
    for (const UncertainDecision& d : decisions) {
        if (ties.empty() || ties.back().uncertainty != d.uncertainty)
            ties.push_back({d.uncertainty, 0, 0});
        ++(d.wrong ? ties.back().wrong : ties.back().right);
    }
    return ties;
}

Tie totalOf(const std::vector<Tie>& ties)
{
    Tie total;
    for (const Tie& t : ties) {
        total.right += t.right;
        total.wrong += t.wrong;
    }
    return total;
}
}  // namespace

double areaUnderRoc(std::vector<UncertainDecision> decisions)
{
    const std::vector<Tie> ties = tiesInOrder(decisions);
    const Tie total = totalOf(ties);
    if (total.right == 0 || total.wrong == 0) return NOT_A_NUMBER;
    double rightBelow = 0, ordered = 0;  // pairs of a right and a more uncertain wrong one
    for (const Tie& t : ties) {
        ordered += t.wrong * (rightBelow + t.right / 2);
        rightBelow += t.right;
    }
    return ordered / (total.right * total.wrong);
}

std::optional<UncertaintyThreshold> suggestedThreshold(std::vector<UncertainDecision> decisions)
{
    const std::vector<Tie> ties = tiesInOrder(decisions);
    const Tie total = totalOf(ties);
    if (total.right == 0 || total.wrong == 0) return std::nullopt;
    UncertaintyThreshold best;
    double rightAbove = total.right, wrongAbove = total.wrong;
    for (size_t i = 0; i + 1 < ties.size(); ++i) {
        rightAbove -= ties[i].right;
        wrongAbove -= ties[i].wrong;
        const double youden = wrongAbove / total.wrong - rightAbove / total.right;
        if (youden > 0 && youden >= best.youden)
            best = {(ties[i].uncertainty + ties[i + 1].uncertainty) / 2, youden};
    }
    if (!(best.youden > 0)) return std::nullopt;
    return best;
}

double expectedCalibrationError(const std::vector<ConfidentDecision>& decisions, int bins)
{
    if (decisions.empty()) return NOT_A_NUMBER;
    std::vector<double> surplus(static_cast<size_t>(bins), 0);  // correct minus expected correct
    for (const ConfidentDecision& d : decisions) {
        const int bin = static_cast<int>(std::ceil(d.probability * bins)) - 1;
        surplus[static_cast<size_t>(std::clamp(bin, 0, bins - 1))] +=
            (d.correct ? 1 : 0) - d.probability;
    }
    double sum = 0;
    for (const double s : surplus) sum += std::abs(s);
    return sum / static_cast<double>(decisions.size());
}

std::vector<ReliabilityBin> reliability(std::vector<ConfidentDecision> decisions, int bins)
{
    std::stable_sort(decisions.begin(), decisions.end(),
                     [](const auto& a, const auto& b) { return a.probability < b.probability; });
    const size_t n = decisions.size(), parts = std::min(static_cast<size_t>(bins), n);
    std::vector<ReliabilityBin> diagram(parts);
    for (size_t part = 0; part < parts; ++part) {
        ReliabilityBin& bin = diagram[part];
        for (size_t i = part * n / parts; i < (part + 1) * n / parts; ++i) {
            ++bin.decisions;
            bin.probability += decisions[i].probability;
            bin.correct += decisions[i].correct ? 1 : 0;
        }
        bin.probability /= static_cast<double>(bin.decisions);
        bin.correct /= static_cast<double>(bin.decisions);
    }
    return diagram;
}

double calibrationErrorOf(const std::vector<ReliabilityBin>& diagram)
{
    if (diagram.empty()) return NOT_A_NUMBER;
    double surplus = 0, decisions = 0;
    for (const ReliabilityBin& bin : diagram) {
        const auto n = static_cast<double>(bin.decisions);
        surplus += n * std::abs(bin.correct - bin.probability);
        decisions += n;
    }
    return surplus / decisions;
}

double equalMassCalibrationError(std::vector<ConfidentDecision> decisions, int bins)
{
    return calibrationErrorOf(reliability(std::move(decisions), bins));
}

double calibrationErrorByChance(std::vector<ConfidentDecision> decisions, int bins)
{
    constexpr int DRAWS = 200;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    for (int draw = 0; draw < DRAWS; ++draw) {
        for (ConfidentDecision& d : decisions) d.correct = uniform(random) < d.probability;
        sum += equalMassCalibrationError(decisions, bins);
    }
    return sum / DRAWS;
}

double brierScore(const std::vector<ConfidentDecision>& decisions)
{
    if (decisions.empty()) return NOT_A_NUMBER;
    double sum = 0;
    for (const ConfidentDecision& d : decisions) {
        const double error = d.probability - (d.correct ? 1 : 0);
        sum += error * error;
    }
    return sum / static_cast<double>(decisions.size());
}

double negativeLogLikelihood(const std::vector<ConfidentDecision>& decisions)
{
    if (decisions.empty()) return NOT_A_NUMBER;
    constexpr double LEAST = 1e-6;
    double sum = 0;
    for (const ConfidentDecision& d : decisions)
        sum -=
            std::log(std::clamp(d.correct ? d.probability : 1 - d.probability, LEAST, 1 - LEAST));
    return sum / static_cast<double>(decisions.size());
}

double PrecisionAtThreshold::precision() const
{
    return instances == 0 ? NOT_A_NUMBER
                          : static_cast<double>(correct) / static_cast<double>(instances);
}

std::vector<PrecisionAtThreshold> precisionCurve(const std::vector<UncertainDecision>& decisions,
                                                 double step)
{
    double largest = 0;
    for (const UncertainDecision& d : decisions) largest = std::max(largest, d.uncertainty);
    const int last = decisions.empty() ? 0 : static_cast<int>(largest / step) + 1;
    std::vector<PrecisionAtThreshold> curve;
    for (int i = 1; i <= last; ++i) {
        PrecisionAtThreshold at{i * step, 0, 0};
        for (const UncertainDecision& d : decisions) {
            if (!(d.uncertainty < at.threshold)) continue;
            ++at.instances;
            if (!d.wrong) ++at.correct;
        }
        curve.push_back(at);
    }
    return curve;
}
}  // namespace voxeland
