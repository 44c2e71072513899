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
    std::vector<mrpt::math::TPoint3D> points;  //!< [m]
    std::vector<uint32_t> instance;            //!< object of each point; 0: none, or structure
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

/** Reads the annotation of a ScanNet scene: `SCENE_vh_clean_2.ply`,
 *  `SCENE_vh_clean_2.0.010000.segs.json`, `SCENE.aggregation.json`, and the table
 *  `scannetv2-labels.combined.tsv` beside them or up to two folders above.
 *
 *  Objects are `objectId` + 1; a vertex that several objects claim goes to the last. Categories are
 *  NYU40's, or the raw one where that has none; walls, floors and ceilings are structure. Points
 *  stay in the frame of reference of the scan's poses: axisAlignment is not applied.
 *  \param path the scene's folder, or its PLY file
 *  \throws InputError, naming the file, if one is missing, malformed or does not fit the others */
GroundTruth readScanNetGroundTruth(const std::string& path);

/** Reads the annotation of a SceneNN scene: `NNN.ply`, whose vertices have a `label`, and
 * `NNN.xml`, which tells the object of each label. Categories are those in `nyu_class`; labels
 * without one, or without a `text`, are void, and walls, floors and ceilings are structure. \param
 * path the scene's folder, or its PLY file \throws InputError, naming the file, if one is missing
 * or malformed */
GroundTruth readSceneNNGroundTruth(const std::string& path);

/** Reads ground truth of a named format, one of groundTruthFormats().
 *  \throws ConfigurationError for another one, InputError as the reader of the format */
GroundTruth readGroundTruth(const std::string& path, const std::string& format);

/** Names of the formats that can be read. */
std::vector<std::string> groundTruthFormats();
}  // namespace voxeland
