// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <random>

namespace voxeland::simulation
{
/** Random numbers that are the same with every standard library: its distributions are left to the
 *  implementation, so only its engine is used. */
class Random
{
 public:
    /** Independent sequences for different (seed, stream, index), e.g. one for each frame. */
    explicit Random(uint64_t seed, uint64_t stream = 0, uint64_t index = 0);

    /** Uniform in [0,1). */
    [[nodiscard]] double uniform();
    /** Uniform in [low, high). */
    [[nodiscard]] float uniform(float low, float high);
    /** Normal with mean 0 and the given standard deviation, cut off at 4.5 times that. */
    [[nodiscard]] float normal(float sigma);
    /** Uniform in {0, ..., count-1}; count must be positive. */
    [[nodiscard]] int below(int count);
    /** Poisson-distributed count with a small mean. */
    [[nodiscard]] int poisson(double mean);
    /** true with the given probability. */
    [[nodiscard]] bool chance(double probability) { return uniform() < probability; }

 private:
    std::mt19937_64 m_engine;
};
}  // namespace voxeland::simulation
