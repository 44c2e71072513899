// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/observations/RunLengthMask.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxeland
{
/** Run lengths from the compressed text of COCO's masks (five bits a character, the lowest first,
 *  each from the fourth on as the difference to the last but one).
 *  \throws std::invalid_argument if the text is no such thing */
std::vector<uint32_t> decodeCocoCounts(const std::string& counts);

/** Mask from COCO's run lengths, which go down the columns: unset first, as in RunLengthMask.
 *  \throws std::invalid_argument if they do not add up to the size */
RunLengthMask maskFromColumnRuns(int width, int height, const std::vector<uint32_t>& runs);

/** Mask of all pixels whose centre is in any of the polygons, given as x0, y0, x1, y1, ... in
 *  pixels, where pixel (c, r) covers [c, c+1) x [r, r+1); inside is what an odd number of edges
 *  surrounds. COCO's own rasterization rounds the outline, so that the rim may differ by one pixel.
 *  \throws std::invalid_argument if a polygon has fewer than three points or one far off */
RunLengthMask maskFromPolygons(int width, int height,
                               const std::vector<std::vector<double>>& polygons);
}  // namespace voxeland
