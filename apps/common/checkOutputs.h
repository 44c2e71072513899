// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::apps
{
/** Makes sure before the work that no output would replace an input or another output, and that all
 * outputs may be written. Empty names are passed over.
 *  \throws ConfigurationError, or OutputError as checkWritable(), naming the file */
void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);
}  // namespace voxeland::apps
