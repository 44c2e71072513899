// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Random.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voxeland::simulation
{
namespace
{
/** splitmix64's mixing: neighbouring inputs give unrelated outputs. */
uint64_t mix(uint64_t x)
{
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}
constexpr int QUANTILES = 8192;  //!< of the normal distribution, between which is interpolated

/** The standard normal distribution's quantiles i / QUANTILES, by bisection; ends at 4.5. */
std::vector<float> quantiles()
{
    std::vector<float> result;
    for (int i = 0; i <= QUANTILES; ++i) {
        double low = -4.5, high = 4.5;
        while (high - low > 1e-8) {
            const double middle = (low + high) / 2;
            const double below = std::erfc(-middle / std::sqrt(2.0)) / 2;
            (below * QUANTILES < i ? low : high) = middle;
        }
        result.push_back(static_cast<float>(low));
    }
    return result;
}
}  // namespace

Random::Random(uint64_t seed, uint64_t stream, uint64_t index)
    : m_engine(mix(mix(mix(seed) + stream) + index))
{
}

double Random::uniform()
{
    return static_cast<double>(m_engine() >> 11) * 0x1.0p-53;
}

float Random::uniform(float low, float high)
{
    return low + (high - low) * static_cast<float>(uniform());
}

float Random::normal(float sigma)
{
    static const auto table = quantiles();
    const float at = static_cast<float>(uniform()) * QUANTILES;
    const auto i = std::min(static_cast<size_t>(at), size_t{QUANTILES - 1});
    return sigma * (table[i] + (at - static_cast<float>(i)) * (table[i + 1] - table[i]));
}

int Random::below(int count)
{
    return static_cast<int>(uniform() * count);
}

int Random::poisson(double mean)
{
    const double limit = std::exp(-mean);
    int n = 0;
    for (double product = uniform(); product > limit; product *= uniform()) ++n;
    return n;
}
}  // namespace voxeland::simulation
