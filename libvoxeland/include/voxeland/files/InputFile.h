// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

namespace voxeland
{
/** Makes sure that a file can be read to an end: a pipe, device or socket may keep a reader waiting
 *  or never end, so that only regular files are read (a link to one is one; /dev/stdin is, where a
 *  file is redirected to it), and none of those that the system makes up, as below /proc.
 *  \param file its name \param purpose what it is, for the message, such as "the model"
 *  \return its size [bytes]
 *  \throws InputError, naming it, if it is missing, a folder or anything else but a regular file */
uint64_t checkInputFile(const std::string& file, const std::string& purpose);
}  // namespace voxeland
