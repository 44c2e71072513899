// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::apps
{
/** What a program reads, or writes, by name. Empty names are passed over. */
struct NamedFiles
{
    std::vector<std::string> files;
    std::vector<std::string> rawlogs;  //!< or simplemaps: each is several files, see RawlogFiles
    std::vector<std::string> folders;  //!< for files of other names than an input's
};

/** Makes sure before the work that no output would replace an input or another output, or go
 * amid the images of a rawlog, and that all files to write may be written. A rawlog may replace
 * itself.
 *  \throws ConfigurationError, or OutputError as checkWritable(), naming the file */
void checkOutputs(const NamedFiles& outputs, const NamedFiles& inputs);
}  // namespace voxeland::apps
