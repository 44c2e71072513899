// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace voxeland
{
/** Rectangle of whole pixels: columns [x, x+width), rows [y, y+height). */
struct PixelBox
{
    int32_t x = 0, y = 0, width = 0, height = 0;

    friend bool operator==(const PixelBox& a, const PixelBox& b)
    {
        return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
    }
};
}  // namespace voxeland
