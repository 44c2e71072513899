// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

namespace voxeland
{
/** Correlation between any two observations that repeat one another: the opinions about one side of
 * an object, or the points that a frame measures in one voxel. */
inline constexpr double CORRELATION_OF_REPETITIONS = 0.5;

/** What each of n observations counts that repeat one another, in (0,1]: together they are worth
 * n / (1 + (n - 1) r) independent ones, r being their correlation (Kish's effective sample size of
 * a cluster, "Survey Sampling", 1965), at most 1 / r. \param n what is below 1 is part of one */
inline double weightOfRepetition(double n)
{
    return 1 / (1 + (std::max(n, 1.0) - 1) * CORRELATION_OF_REPETITIONS);
}
}  // namespace voxeland
