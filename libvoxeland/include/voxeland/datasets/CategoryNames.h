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

/** Category names from a table in UTF-8: CSV (see parseCsv()) whose rows are a number, a name and
 *  anything else, below a header or not; rows of names without numbers, below a header that names
 *  their column or not, numbered from 0; the classes of a label map, "name,class" as
 *  share/labels/coco80.csv, numbered from 0 in order of appearance; or YAML with a key "names", as
 *  the data.yaml of Ultralytics. Empty if the text is.
 *  \param source name of the file, for messages
 *  \throws InputError, naming the line, for any other */
CategoryNames categoryNamesFromTable(const std::string& text, const std::string& source);

/** Reads a file of category names: a table as above, or JSON, which may be an object with a list
 *  "categories" of {"id": number, "name": text} as COCO's files have, such a list, a list of names
 *  alone, numbered from 0, or an object of names by number or numbers by name.
 *  \throws InputError, naming the file, if it cannot be read or names nothing */
CategoryNames readCategoryNames(const std::string& file);
}  // namespace voxeland
