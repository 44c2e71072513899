// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/datasets/CategoryNames.h"

#include <optional>
#include <string>

namespace voxeland
{
/** The names of a YAML text's key "names", as in the data.yaml of Ultralytics: a list, numbered
 * from 0, or a mapping of numbers to names, in lines of their own or in brackets. Nothing if there
 * is no such key. Other keys are passed over. \param source name of the file, for messages \throws
 * InputError, naming the line, for names in another form */
std::optional<CategoryNames> namesFromYaml(const std::string& text, const std::string& source);
}  // namespace voxeland
