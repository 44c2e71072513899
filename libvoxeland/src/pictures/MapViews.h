// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/files/WrittenFiles.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/math/TPoint3D.h>

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** How pictures of a map are made. */
struct ViewOptions
{
    /** Up in the map's frame, of any length > 0; not given: estimateUp(). */
    std::optional<mrpt::math::TVector3D> up;
    int height = 1000;  //!< of a picture, which is half as wide again, legend included [px]
};

/** Pictures of a map. */
struct MapViews
{
    /** One of them, as a PNG file. */
    struct Picture
    {
        std::string name;          //!< of its file, without folder and ending
        std::string title;         //!< what it shows
        std::vector<uint8_t> png;  //!< the file's bytes
    };
    std::vector<Picture> pictures;
    double azimuth = 0;  //!< where the perspective is seen from: direction from the middle of the
                         //!< map to the eye, in the gravity-aligned frame [rad]
};

/** Draws a map as pictures with legends, by software (no display, no GPU). Five colourings
 *  (`instances`, `categories`, `uncertainty_instances`, `uncertainty_categories`,
 *  `uncertainty_semantic`: blue low, red high, all on one scale, up to the larger 99 % quantile of
 *  the first two) in two views:
 *  - `NAME_top`: from above, to scale, the map's x to the right;
 *  - `NAME_perspective`: from above one of the corners, that which shows most of the objects.
 *
 *  Occupied voxels are drawn. What no detection speaks for is light grey; where it lies in front of
 *  an object it is translucent, and above 95 % of the objects' voxels it is cut away, so that
 *  neither ceiling nor walls hide the room (without any object: above 90 % of the height).
 *  \throws ConfigurationError for options out of range */
MapViews drawViews(const SemanticVoxelMap& map, const ViewOptions& options = ViewOptions());

/** Writes the pictures of drawViews() as `NAME.png`.
 *  \param folder made if missing
 *  \param written those completed are added to it
 *  \throws OutputError if one of them cannot be written
 *  \throws ConfigurationError for options out of range */
void exportViews(const SemanticVoxelMap& map, const std::string& folder, WrittenFiles& written,
                 const ViewOptions& options = ViewOptions());
}  // namespace voxeland
