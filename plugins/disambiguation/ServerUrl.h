// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace voxeland
{
/** Whether what is sent to a URL stays on this machine: its host is `localhost`, of 127.0.0.0/8 or
 * ::1, as libcurl reads it. Names that only begin so ("127.0.0.1.example.org") are others'. */
bool isThisMachine(const std::string& url);

/** Whether what is sent to a URL can be read on its way: it is no https. */
bool isUnencrypted(const std::string& url);
}  // namespace voxeland
