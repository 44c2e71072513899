// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** Reads the names of a network's classes, in the order of their numbers, from a file: names alone,
 *  one a line; lines "number,name", as share/labels/coco91.csv, or the same as JSON, of which the
 *  lowest number is class 0; or a table "name,class" as share/labels/coco80.csv, of which the
 *  classes count, in order of appearance. Classes without a name have an empty one.
 *  \throws InputError, naming the file, if it cannot be read or names nothing */
std::vector<std::string> readClassNames(const std::string& file);
}  // namespace voxeland
