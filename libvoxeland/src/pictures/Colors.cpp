// SPDX-License-Identifier: BSD-3-Clause
#include "Colors.h"

#include "voxeland/map/SemanticVoxelMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace voxeland
{
namespace
{
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

/** Gives away its tones, each time one far from those that are taken. */
class Palette
{
 public:
    /** \param start the tone to begin the search with, any number */
    Color take(size_t start)
    {
        constexpr int ENOUGH = 110 * 110;
        int best = -1;
        Color chosen;
        for (size_t i = 0; i < TONES && best < ENOUGH; ++i) {
            const Color candidate = distinctColor((start + i) % TONES);
            int nearest = ENOUGH;
            for (const Color& other : m_taken)
                nearest = std::min(nearest, squaredDistance(candidate, other));
            if (nearest <= best) continue;
            best = nearest;
            chosen = candidate;
        }
        m_taken.push_back(chosen);
        return chosen;
    }

 private:
    static constexpr size_t TONES = 60;  //!< before they repeat
    std::vector<Color> m_taken;
};
}  // namespace

std::map<instance_id_t, Color> instanceColors(const SemanticVoxelMap& map)
{
    std::vector<const Instance*> biggestFirst;
    for (const auto& [id, instance] : map.instances()) biggestFirst.push_back(&instance);
    std::stable_sort(biggestFirst.begin(), biggestFirst.end(),
                     [](const Instance* a, const Instance* b) { return a->voxels > b->voxels; });
    Palette palette;
    std::map<instance_id_t, Color> colors = {{UNKNOWN_INSTANCE, UNKNOWN_COLOR}};
    for (const Instance* instance : biggestFirst) colors[instance->id] = palette.take(instance->id);
    return colors;
}

std::map<std::string, Color> categoryColors(const std::set<std::string>& names)
{
    Palette palette;
    std::map<std::string, Color> colors;
    for (const std::string& name : names) colors[name] = palette.take(hashOf(name));
    return colors;
}

Color uncertaintyColor(double share)
{
    const double s = std::clamp(share, 0.0, 1.0);
    return fromHsv((1 - s) * 2 / 3, 0.9, 0.95);
}
}  // namespace voxeland
