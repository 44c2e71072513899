// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland::apps
{
/** The words of a command as they are typed in a shell, quoted where needed; words with what a
 *  terminal would not show are written with escapes, as bash reads them: $'\x1b'. */
std::string asTyped(const std::vector<std::string>& words);
}  // namespace voxeland::apps
