// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/evidence/OccupancyFilter.h"

#include <cmath>
#include <stdexcept>

namespace voxeland
{
namespace
{
constexpr double STEPS_PER_NAT = 2048;
}

OccupancyFilter::OccupancyFilter(const Options& o)
{
    const bool ordered = 0 < o.prob_min && o.prob_min <= o.prob_miss && o.prob_miss < 0.5 &&
                         0.5 < o.prob_hit && o.prob_hit <= o.prob_max && o.prob_max < 1;
    if (!ordered)
        throw std::invalid_argument(
            "occupancy needs 0 < prob_min <= prob_miss < 0.5 < prob_hit <= prob_max < 1");
    m_hit = fromProbability(o.prob_hit);
    m_miss = fromProbability(o.prob_miss);
    m_min = fromProbability(o.prob_min);
    m_max = fromProbability(o.prob_max);
}

OccupancyFilter OccupancyFilter::weakened(double weight) const
{
    OccupancyFilter result = *this;
    result.m_hit = static_cast<int>(std::lround(m_hit * weight));
    result.m_miss = static_cast<int>(std::lround(m_miss * weight));
    return result;
}

double OccupancyFilter::probability(log_odds_t value)
{
    if (value == UNOBSERVED) return 0.5;
    return 1 / (1 + std::exp(-value / STEPS_PER_NAT));
}

log_odds_t OccupancyFilter::fromProbability(double probability)
{
    const double steps = std::round(std::log(probability / (1 - probability)) * STEPS_PER_NAT);
    if (!(std::abs(steps) < INT16_MAX))
        throw std::invalid_argument("occupancy probabilities must lie within 1e-6 and 1 - 1e-6");
    return static_cast<log_odds_t>(steps);
}
}  // namespace voxeland
