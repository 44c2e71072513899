// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

namespace voxeland
{
/** From now on this process shows something else in place of a text, wherever printable() or
 *  withoutHidden() show it: what a variable of the environment holds, a key. It stays as it is for
 *  all that is computed. May be called from any thread.
 *  \param text large and small letters make no difference, as parts of a URL lose them; of fewer
 *  than 6 characters it is too common to be hidden, and nothing is done */
void hideText(const std::string& text, const std::string& shownAs);

/** A text with what hideText() names replaced, for all that is shown or kept without printable().
 */
std::string withoutHidden(std::string_view text);
}  // namespace voxeland
