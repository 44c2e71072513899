// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/exporters/Exporter.h"
#include "voxeland/map/SemanticVoxelMap.h"

#include <mrpt/opengl/opengl_frwds.h>

#include <memory>
#include <string>

namespace mrpt::opengl
{
class COctoMapVoxels;
}

namespace voxeland
{
class GravityAlignedFrame;

/** The occupied voxels of a map as cubes, coloured by instance. */
std::shared_ptr<mrpt::opengl::COctoMapVoxels> voxelCubes(const SemanticVoxelMap& map);

/** Writes those cubes, the instances' oriented boxes and their names ("3 chair") as a scene for
 *  MRPT's SceneViewer3D. The scene is level: everything in it is in the map's frame, which is
 *  itself turned so that up is the scene's z axis.
 *  \param frame tells where up is \throws OutputError if the file cannot be written */
void exportScene(const SemanticVoxelMap& map, const GravityAlignedFrame& frame,
                 const std::string& file);

/** exportScene(). */
Exporter sceneExporter();
}  // namespace voxeland
