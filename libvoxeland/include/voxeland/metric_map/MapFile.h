// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

namespace voxeland
{
class CVoxelandMap;

/** Reads a map file (*.voxeland: MRPT serialization, gz).
 *  \throws InputError, naming the file, if it is missing, truncated or something else */
std::shared_ptr<CVoxelandMap> loadMap(const std::string& file);

/** Writes a map file: first under a temporary name in the same folder, then renamed, so that a run
 * that dies leaves the old file as it was. \throws OutputError, naming the file, if it cannot be
 * written whole */
void saveMap(const CVoxelandMap& map, const std::string& file);
}  // namespace voxeland
