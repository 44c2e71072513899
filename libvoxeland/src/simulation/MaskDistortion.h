// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/simulation/Random.h"
#include "voxeland/simulation/SimulationOptions.h"

#include <cstdint>
#include <vector>

namespace voxeland::simulation
{
/** A binary image, 0 or 1 for each pixel, row-major. */
struct Bitmap
{
    int width = 0, height = 0;
    std::vector<uint8_t> pixels;

    [[nodiscard]] int area() const;
};

/** What a network makes of an exact mask: shifted, grown or shrunk, with a wavy boundary.
 *  \param scale pixels of this image for one of an image 640 wide */
[[nodiscard]] Bitmap distorted(const Bitmap& mask, const DetectorOptions& options, float scale,
                               Random& random);

/** Cuts a mask in two along a random line near its middle. \return the larger part first */
[[nodiscard]] std::vector<Bitmap> cutInTwo(const Bitmap& mask, Random& random);
}  // namespace voxeland::simulation
