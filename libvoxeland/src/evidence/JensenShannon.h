// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace voxeland
{
/** Jensen-Shannon divergence of two discrete distributions over the same outcomes, in bits: 0 for
 *  equal ones, 1 for ones without a common outcome.
 *  JSD(p,q) = KL(p|m)/2 + KL(q|m)/2 with m = (p+q)/2, logarithms of base 2.
 *  \param p,q of equal length, each summing to 1; throws std::invalid_argument otherwise */
double jensenShannonDivergence(const std::vector<double>& p, const std::vector<double>& q);
}  // namespace voxeland
