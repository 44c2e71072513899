// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Appearance.h"

#include <cstdint>
#include <string>
#include <vector>

/** \file
 * Objects painted in a colour of their category, so that a program that looks at an image
 * can tell what it shows. All paints are fully saturated, which nothing else in an apartment is. */
namespace voxeland::simulation
{
/** Categories that have a paint: all those of apartments. */
const std::vector<std::string>& paintedCategories();

/** \throws std::out_of_range if the category has no paint */
[[nodiscard]] Colour paintOf(const std::string& category);

/** The category whose paint a pixel shows, in whatever light; nullptr if it shows none. */
[[nodiscard]] const std::string* categoryOfPaint(uint8_t red, uint8_t green, uint8_t blue);
}  // namespace voxeland::simulation
