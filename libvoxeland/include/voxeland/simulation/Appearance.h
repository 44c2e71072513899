// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace voxeland::simulation
{
/** Colour with components in [0,1]. */
struct Colour
{
    float r = 0, g = 0, b = 0;
};

/** How a surface's colour varies over the solid. */
enum class Texture : uint8_t
{
    Plain,     //!< one colour
    Wood,      //!< grain along the solid's longest side
    Fabric,    //!< fine grain
    Planks,    //!< floor boards along x
    Tiles,     //!< square tiles with joints
    Screen,    //!< a display that is on
    Painting,  //!< blotches of several colours
    Spines     //!< backs of books, side by side along y
};

/** What the surface of a solid looks like. */
struct Appearance
{
    Colour colour;
    Texture texture = Texture::Plain;
    uint32_t variation = 0;  //!< makes textures of the same kind differ
};

/** Colour of a surface before lighting.
 *  \param x,y,z point in the solid's own frame [m] */
[[nodiscard]] Colour surfaceColour(const Appearance& appearance, float x, float y, float z);
}  // namespace voxeland::simulation
