// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace voxeland
{
/** Log-odds ln(p/(1-p)) of a voxel being occupied, in two bytes: steps of 1/2048 nat. */
using log_odds_t = int16_t;

/** A voxel that was never observed. */
inline constexpr log_odds_t UNOBSERVED = INT16_MIN;

/** Binary Bayes filter for occupancy (Thrun et al., "Probabilistic Robotics", 4.2 and 9.2): each
 *  observation adds the log-odds of the inverse sensor model, clamped so that the map can change
 *  its mind. The prior is 0.5. */
class OccupancyFilter
{
 public:
    /** Inverse sensor model and clamping limits, as probabilities. */
    struct Options
    {
        double prob_hit = 0.7;   //!< of occupied, given a measured point in the voxel; in (0.5,1)
        double prob_miss = 0.4;  //!< of occupied, given a ray through the voxel; in (0,0.5)
        double prob_min = 0.12;  //!< lower clamping limit; in (0,0.5)
        double prob_max = 0.97;  //!< upper clamping limit; in (0.5,1)
    };

    /** Throws std::invalid_argument unless 0 < prob_min <= prob_miss < 0.5 < prob_hit <= prob_max <
     * 1 and the limits fit log_odds_t. */
    explicit OccupancyFilter(const Options& options);
    OccupancyFilter() : OccupancyFilter(Options()) {}

    [[nodiscard]] log_odds_t afterHit(log_odds_t before) const { return updated(before, m_hit); }
    [[nodiscard]] log_odds_t afterMiss(log_odds_t before) const { return updated(before, m_miss); }

    /** A filter of the same limits whose observations count less. \param weight in [0,1]; 1: this
     */
    [[nodiscard]] OccupancyFilter weakened(double weight) const;

    /** Probability in (0,1); 0.5 for UNOBSERVED. */
    static double probability(log_odds_t value);
    /** Whether occupied is more likely than free; false for UNOBSERVED. */
    static bool isOccupied(log_odds_t value) { return value > 0; }
    /** Whether free is more likely than occupied; false for UNOBSERVED. */
    static bool isFree(log_odds_t value) { return value < 0 && value != UNOBSERVED; }
    /** Nearest representable log-odds of a probability in (0,1). */
    static log_odds_t fromProbability(double probability);

 private:
    [[nodiscard]] log_odds_t updated(log_odds_t before, int delta) const
    {
        const int sum = (before == UNOBSERVED ? 0 : before) + delta;
        return static_cast<log_odds_t>(sum < m_min ? m_min : (sum > m_max ? m_max : sum));
    }

    int m_hit, m_miss, m_min, m_max;
};
}  // namespace voxeland
