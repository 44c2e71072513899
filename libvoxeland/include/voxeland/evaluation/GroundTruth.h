// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <string>
#include <vector>

namespace voxeland
{
/** Annotated points of a scene, whatever file they come from; world frame of the map's poses. */
struct GroundTruth
{
    std::vector<mrpt::math::TPoint3Df> points;  //!< [m]
    std::vector<uint32_t> instance;             //!< object of each point; 0: none, or structure
    std::vector<uint32_t> category;  //!< position in `names` of each point's category, wherever
                                     //!< instance is not 0
    std::vector<std::string> names;  //!< category names
};

/** Reads a labelled point cloud: a PLY file (binary little endian or ascii) whose vertices have
 *  x, y, z and integers `instance` (0 or less: none, or structure) and `category`, in any order and
 *  among others, with a `categories.csv` (header `index,name`) beside it.
 *  \param path the PLY file, or a folder with a `ground_truth.ply`
 *  \throws InputError, naming the file, if one is missing, malformed, truncated or empty */
GroundTruth readPlyGroundTruth(const std::string& path);

/** Reads ground truth of a named format, one of groundTruthFormats().
 *  \throws ConfigurationError for another one, InputError as the reader of the format */
GroundTruth readGroundTruth(const std::string& path, const std::string& format);

/** Names of the formats that can be read. */
std::vector<std::string> groundTruthFormats();
}  // namespace voxeland
