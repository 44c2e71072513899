// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

namespace voxeland
{
class CVoxelandMap;

/** Lets a run go on where another one stopped: where `output` is the same map with decisions, they
 * are taken over. Anything else is left for the run to replace.
 *  \return number of decisions taken over */
size_t takeOverDecisions(CVoxelandMap& map, const std::string& output);
}  // namespace voxeland
