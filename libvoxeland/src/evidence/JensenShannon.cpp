// SPDX-License-Identifier: BSD-3-Clause
#include "JensenShannon.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace voxeland
{
namespace
{
void checkDistribution(const std::vector<double>& p)
{
    const double sum = std::accumulate(p.begin(), p.end(), 0.0);
    if (!(std::abs(sum - 1) < 1e-6))
        throw std::invalid_argument("jensenShannonDivergence: probabilities must sum to 1");
}
}  // namespace

double jensenShannonDivergence(const std::vector<double>& p, const std::vector<double>& q)
{
    if (p.size() != q.size())
        throw std::invalid_argument("jensenShannonDivergence: distributions of unequal length");
    checkDistribution(p);
    checkDistribution(q);
    double divergence = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const double m = 0.5 * (p[i] + q[i]);
        if (p[i] > 0) divergence += 0.5 * p[i] * std::log2(p[i] / m);
        if (q[i] > 0) divergence += 0.5 * q[i] * std::log2(q[i] / m);
    }
    return std::clamp(divergence, 0.0, 1.0);
}
}  // namespace voxeland
