// SPDX-License-Identifier: BSD-3-Clause
#include "CategoryPaint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace voxeland::simulation
{
namespace
{
/** Hues are numbers in [0,6): red 0, yellow 1, green 2, cyan 3, blue 4, magenta 5. */
constexpr float HUES = 6;

float hueStep()
{
    return HUES / static_cast<float>(paintedCategories().size());
}
}  // namespace

const std::vector<std::string>& paintedCategories()
{
    static const std::vector<std::string> names = {
        "backpack",     "bed",          "book",       "bookshelf",       "bottle",
        "bowl",         "box",          "cabinet",    "chair",           "couch",
        "cup",          "dining table", "floor lamp", "kitchen cabinet", "laptop",
        "microwave",    "nightstand",   "picture",    "plant stand",     "potted plant",
        "refrigerator", "toilet",       "tv",         "wardrobe"};
    return names;
}

Colour paintOf(const std::string& category)
{
    const auto& names = paintedCategories();
    const auto at = std::find(names.begin(), names.end(), category);
    if (at == names.end()) throw std::out_of_range("there is no paint for '" + category + "'");
    constexpr float BRIGHTNESS = 0.9F;
    const float hue = static_cast<float>(at - names.begin()) * hueStep();
    const auto part = [hue](float middle) {
        const float distance = std::abs(std::remainder(hue - middle, HUES));
        return BRIGHTNESS * std::clamp(2 - distance, 0.0F, 1.0F);
    };
    return {part(0), part(2), part(4)};
}

const std::string* categoryOfPaint(uint8_t red, uint8_t green, uint8_t blue)
{
    constexpr float LEAST_SATURATION = 0.75F, LEAST_BRIGHTNESS = 60;
    const float r = red, g = green, b = blue;
    const float most = std::max({r, g, b}), least = std::min({r, g, b}), range = most - least;
    if (most < LEAST_BRIGHTNESS || range < LEAST_SATURATION * most) return nullptr;
    const float hue = most == r   ? (g - b) / range
                      : most == g ? 2 + (b - r) / range
                                  : 4 + (r - g) / range;
    const float steps = (hue < 0 ? hue + HUES : hue) / hueStep();
    const auto& names = paintedCategories();
    return &names[static_cast<size_t>(std::lround(steps)) % names.size()];
}
}  // namespace voxeland::simulation
