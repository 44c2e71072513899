// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/VoxelEvidence.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace voxeland
{
class SemanticVoxelMap;

/** 8-bit colour as exporters write it. */
struct Color
{
    uint8_t red = 0, green = 0, blue = 0;

    friend bool operator==(const Color& a, const Color& b)
    {
        return a.red == b.red && a.green == b.green && a.blue == b.blue;
    }
    friend bool operator!=(const Color& a, const Color& b) { return !(a == b); }
};

/** Light grey: what no detection speaks for. */
inline constexpr Color UNKNOWN_COLOR{225, 225, 225};

/** Colours of all instances of a map, the same in every export of it, and UNKNOWN_COLOR for
 *  UNKNOWN_INSTANCE. They are as different as 60 tones allow; the biggest instances choose first,
 *  starting from a tone of their id. */
std::map<instance_id_t, Color> instanceColors(const SemanticVoxelMap& map);

/** Colours of some categories, as different from each other as 60 tones allow. The choice starts
 *  from the name, so that a category nearly always looks the same, whatever else there is. */
std::map<std::string, Color> categoryColors(const std::set<std::string>& names);

/** Blue (0) over cyan, green and yellow to red (1). \param share clamped to [0,1] */
Color uncertaintyColor(double share);
}  // namespace voxeland
