// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "level/HeightSlice.h"
#include "voxeland/exporters/Exporter.h"

namespace voxeland
{
/** Writes gridOf() serialized and compressed (.gridmap, as MRPT's programs read it). \throws
 * OutputError if that fails */
void exportGridmap(const HeightSlice& slice, const std::string& file);

/** The image beside a YAML file of ROS's map_server: the same name, ending in .pgm.
 *  \throws ConfigurationError unless the name ends in .yaml */
std::string rosImageOf(const std::string& yamlFile);

/** Writes a slice for ROS's map_server: its image, rosImageOf(), and a YAML file.
 *  Cells likelier occupied than free are black, the others white, those never observed grey.
 *  \param written those completed are added to it
 *  \throws ConfigurationError for another ending, OutputError if a file cannot be written */
void exportRosMap(const HeightSlice& slice, const std::string& yamlFile, WrittenFiles& written);

/** exportGridmap() and exportRosMap() of the heights in the settings, or else of those in which a
 * person moves. */
Exporter gridmapExporter();
Exporter rosMapExporter();
}  // namespace voxeland
