// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evidence/Dirichlet.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace voxeland
{
double digamma(double x)
{
    double shift = 0;
    for (; x < 10; x += 1) shift -= 1 / x;
    const double r = 1 / (x * x);
    const double series =
        r * (1. / 12 - r * (1. / 120 - r * (1. / 252 - r * (1. / 240 - r * (1. / 132)))));
    return shift + std::log(x) - 0.5 / x - series;
}

std::string toString(EntropyMeasure measure)
{
    switch (measure) {
        case EntropyMeasure::expected:
            return "expected";
        case EntropyMeasure::paper:
            return "paper";
        case EntropyMeasure::mean:
            return "mean";
    }
    throw std::invalid_argument("not an entropy measure");
}

EntropyMeasure entropyMeasureFromString(const std::string& name)
{
    for (const auto m : {EntropyMeasure::expected, EntropyMeasure::paper, EntropyMeasure::mean})
        if (name == toString(m)) return m;
    throw std::invalid_argument("'" + name + "' is not one of expected, paper, mean");
}

double dirichletEntropy(const std::vector<double>& concentration, EntropyMeasure measure)
{
    const double total = std::accumulate(concentration.begin(), concentration.end(), 0.0);
    size_t positive = 0;
    for (const double a : concentration) positive += a > 0 ? 1 : 0;
    if (positive < 2) return 0;

    double weighted = 0;
    for (const double a : concentration) {
        if (!(a > 0)) continue;
        switch (measure) {
            case EntropyMeasure::expected:
                weighted += a * digamma(a + 1);
                break;
            case EntropyMeasure::paper:
                weighted += a * digamma(a);
                break;
            case EntropyMeasure::mean:
                weighted += a * std::log(a);
                break;
        }
    }
    switch (measure) {
        case EntropyMeasure::expected:
            return digamma(total + 1) - weighted / total;
        case EntropyMeasure::paper:
            return digamma(total) - weighted / total;
        case EntropyMeasure::mean:
            return std::log(total) - weighted / total;
    }
    throw std::invalid_argument("not an entropy measure");
}

double shannonEntropy(const std::vector<double>& probabilities)
{
    double h = 0;
    for (const double p : probabilities)
        if (p > 0) h -= p * std::log(p);
    return h;
}

double vacuity(double priorStrength, double evidence)
{
    const double total = priorStrength + evidence;
    return total > 0 ? priorStrength / total : 1;
}
}  // namespace voxeland
