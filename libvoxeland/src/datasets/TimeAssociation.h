// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

namespace voxeland
{
/** Pairs the times of two lists, in any order: of all pairs the one closest in time, then the
 *  closest of what is left, and so on; of pairs equally close that of the earlier place in the
 *  first list, then in the second. Takes no more than n log n steps, whatever times repeat.
 *  \param apart of a pair at most [s]
 *  \return for each of the first list the place of its partner in the second, -1 for none */
std::vector<int64_t> associateTimes(const std::vector<double>& first,
                                    const std::vector<double>& second, double apart);
}  // namespace voxeland
