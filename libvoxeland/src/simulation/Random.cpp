// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Random.h"

#include <cmath>

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
    if (m_hasSpareNormal) {
        m_hasSpareNormal = false;
        return sigma * m_spareNormal;
    }
    double x, y, square;
    do {  // Marsaglia's polar method gives two at a time
        x = 2 * uniform() - 1;
        y = 2 * uniform() - 1;
        square = x * x + y * y;
    } while (square >= 1 || square == 0);
    const double scale = std::sqrt(-2 * std::log(square) / square);
    m_spareNormal = static_cast<float>(y * scale);
    m_hasSpareNormal = true;
    return sigma * static_cast<float>(x * scale);
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
