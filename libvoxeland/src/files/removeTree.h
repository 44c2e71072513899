// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace voxeland
{
/** Removes a file, or a folder with all that is in it, as far as that is possible; follows no link.
 * May be called by a handler of signals. \param parent descriptor of its folder, or AT_FDCWD */
void removeTree(int parent, const char* name);
}  // namespace voxeland
