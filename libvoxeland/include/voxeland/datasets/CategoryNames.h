// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace voxeland
{
/** Names of a detector's categories by their numbers. */
using CategoryNames = std::map<int64_t, std::string>;

/** The categories of the COCO dataset, numbered 1 to 91 as in its files (share/labels/coco91.csv;
 *  detectors know 80 of them). */
const CategoryNames& cocoCategoryNames();

/** Reads lines "number,name"; lines that do not start with a number, such as a title, are passed
 *  over. */
CategoryNames categoryNamesFromCsv(const std::string& text);

/** Reads a file of category names: CSV as above, or JSON, which may be an object with a list
 *  "categories" of {"id": number, "name": text} as COCO's files have, such a list, or a list of
 *  names alone, numbered from 0.
 *  \throws InputError, naming the file, if it cannot be read or names nothing */
CategoryNames readCategoryNames(const std::string& file);
}  // namespace voxeland
