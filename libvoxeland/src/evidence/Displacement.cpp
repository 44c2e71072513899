// SPDX-License-Identifier: BSD-3-Clause
#include "Displacement.h"

#include <cmath>

namespace voxeland
{
double probabilityOfStaying(double displacement, double edge)
{
    if (displacement <= 0) return 1;
    if (std::isinf(displacement)) return 0;
    const double s = displacement / (std::sqrt(3) * edge);
    // expm1: exact where s is large and the exponential is nearly 1.
    const double alongOneAxis =
        std::erf(M_SQRT1_2 / s) + std::sqrt(2 / M_PI) * s * std::expm1(-1 / (2 * s * s));
    return alongOneAxis * alongOneAxis * alongOneAxis;
}
}  // namespace voxeland
