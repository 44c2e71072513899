// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/io/Colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace voxeland
{
namespace
{
constexpr size_t PALETTE = 60;  //!< colours given to categories before they repeat

/** \param hue in turns \param saturation, value in [0,1] */
Color fromHsv(double hue, double saturation, double value)
{
    const auto channel = [&](double n) {
        const double k = std::fmod(n + hue * 6, 6.0);
        const double c = value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
        return static_cast<uint8_t>(std::lround(255 * c));
    };
    return {channel(5), channel(3), channel(1)};
}

/** The n-th of a series whose neighbours differ much: hues a golden section apart, three tones. */
Color distinctColor(size_t n)
{
    constexpr double GOLDEN = 0.6180339887498949;
    constexpr std::array<std::array<double, 2>, 3> TONES = {{{0.85, 0.9}, {0.95, 0.65}, {0.55, 1}}};
    const auto& [saturation, value] = TONES[n % TONES.size()];
    const double turns = static_cast<double>(n) * GOLDEN;
    return fromHsv(turns - std::floor(turns), saturation, value);
}

/** FNV-1a: unlike std::hash the same everywhere. */
uint32_t hashOf(const std::string& name)
{
    uint32_t h = 2166136261U;
    for (const char c : name) h = (h ^ static_cast<uint8_t>(c)) * 16777619U;
    return h;
}
int squaredDistance(const Color& a, const Color& b)
{
    const int r = a.red - b.red, g = a.green - b.green, l = a.blue - b.blue;
    return r * r + g * g + l * l;
}
}  // namespace

Color instanceColor(instance_id_t id)
{
    return id == UNKNOWN_INSTANCE ? UNKNOWN_COLOR : distinctColor(id);
}

std::map<std::string, Color> categoryColors(const std::set<std::string>& names)
{
    constexpr int ENOUGH = 110 * 110;
    std::map<std::string, Color> colors;
    for (const std::string& name : names) {
        const size_t start = hashOf(name) % PALETTE;
        int best = -1;
        for (size_t i = 0; i < PALETTE && best < ENOUGH; ++i) {
            const Color candidate = distinctColor((start + i) % PALETTE);
            int nearest = ENOUGH;
            for (const auto& [other, color] : colors)
                if (other != name) nearest = std::min(nearest, squaredDistance(candidate, color));
            if (nearest <= best) continue;
            best = nearest;
            colors[name] = candidate;
        }
    }
    return colors;
}

Color uncertaintyColor(double share)
{
    const double s = std::clamp(share, 0.0, 1.0);
    return fromHsv((1 - s) * 2 / 3, 0.9, 0.95);
}
}  // namespace voxeland
