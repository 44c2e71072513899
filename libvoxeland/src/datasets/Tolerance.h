// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace voxeland
{
/** Whether a file may be used though so many of its predictions cannot: a tenth of them. */
constexpr bool isTolerable(size_t unusable, size_t all)
{
    return 10 * unusable <= all;
}
}  // namespace voxeland
