// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/simulation/Appearance.h"

#include <algorithm>
#include <cmath>

namespace voxeland::simulation
{
namespace
{
/** Pseudo-random value in [0,1) for a cell of a lattice. */
float cellNoise(int x, int y, int z, uint32_t variation)
{
    uint32_t h = variation + static_cast<uint32_t>(x) * 0x8da6b343U +
                 static_cast<uint32_t>(y) * 0xd8163841U + static_cast<uint32_t>(z) * 0xcb1ab31fU;
    h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
    h = (h ^ (h >> 12)) * 0x297a2d39U;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * 0x1.0p-24F;
}

int cell(float x, float size)
{
    return static_cast<int>(std::floor(x / size));
}

/** Distance to the nearest joint of a lattice, as a share of the cell [0, 0.5]. */
float toJoint(float x, float size)
{
    const float inCell = x / size - std::floor(x / size);
    return std::min(inCell, 1 - inCell);
}

Colour scaled(const Colour& c, float f)
{
    return {c.r * f, c.g * f, c.b * f};
}
}  // namespace

Colour surfaceColour(const Appearance& a, float x, float y, float z)
{
    switch (a.texture) {
        case Texture::Plain:
            return a.colour;
        case Texture::Wood:
            return scaled(a.colour, 0.92F + 0.08F * std::sin(90 * y + 4 * std::sin(5 * x + 3 * z)));
        case Texture::Fabric:
            return scaled(a.colour, 0.88F + 0.2F * cellNoise(cell(x, 0.012F), cell(y, 0.012F),
                                                             cell(z, 0.012F), a.variation));
        case Texture::Planks: {
            const int row = cell(y, 0.14F);
            const float shifted = x + 0.37F * static_cast<float>(row);
            const bool joint = toJoint(y, 0.14F) < 0.02F || toJoint(shifted, 1.2F) < 0.003F;
            const float tone = cellNoise(cell(shifted, 1.2F), row, 0, a.variation);
            return scaled(a.colour, joint ? 0.6F : 0.85F + 0.2F * tone);
        }
        case Texture::Tiles: {
            const bool joint = toJoint(x, 0.3F) < 0.015F || toJoint(y, 0.3F) < 0.015F;
            const float tone = cellNoise(cell(x, 0.3F), cell(y, 0.3F), 0, a.variation);
            return scaled(a.colour, joint ? 0.7F : 0.95F + 0.07F * tone);
        }
        case Texture::Screen: {
            const float glow =
                0.5F + 0.5F * std::sin(7 * y + 3 * z + static_cast<float>(a.variation));
            return {0.08F + 0.1F * glow, 0.12F + 0.25F * glow, 0.25F + 0.4F * glow};
        }
        case Texture::Painting: {
            const int cx = cell(y + 0.05F * std::sin(20 * z), 0.16F), cz = cell(z, 0.13F);
            return {0.3F + 0.7F * cellNoise(cx, 0, cz, a.variation),
                    0.3F + 0.6F * cellNoise(cx, 1, cz, a.variation),
                    0.2F + 0.5F * cellNoise(cx, 2, cz, a.variation)};
        }
        case Texture::Spines: {
            const int book = cell(y, 0.035F);
            if (toJoint(y, 0.035F) < 0.06F) return {0.1F, 0.08F, 0.08F};
            return {0.25F + 0.65F * cellNoise(book, 0, 0, a.variation),
                    0.2F + 0.5F * cellNoise(book, 1, 0, a.variation),
                    0.2F + 0.5F * cellNoise(book, 2, 0, a.variation)};
        }
    }
    return a.colour;
}
}  // namespace voxeland::simulation
