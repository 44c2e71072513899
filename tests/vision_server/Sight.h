// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::test
{
/** The category that encoded pictures show, judged by their pixels alone: of the paints of
 * simulated objects (voxeland/simulation/CategoryPaint.h), the one that covers most of what the
 * pictures outline, or of all they show where they outline nothing. Empty if there is none.
 * \throws std::runtime_error if a picture cannot be decoded */
std::string categoryShown(const std::vector<std::string>& pictures);
}  // namespace voxeland::test
