// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace voxeland
{
/** A piece of an answer. */
struct AnswerToken
{
    enum class Kind
    {
        word,  //!< letters and digits, in lower case; of scripts without blanks a single character
        mark,  //!< punctuation that parts words: one of . ? , : ( ) / - and the end of a line
        tag    //!< what stands between < and >
    };
    Kind kind = Kind::word;
    std::string text;

    [[nodiscard]] bool isWord() const { return kind == Kind::word; }
    [[nodiscard]] bool isMark(char mark) const
    {
        return kind == Kind::mark && text.size() == 1 && text[0] == mark;
    }
};
using AnswerTokens = std::vector<AnswerToken>;

/** The words of an answer and what parts them. Markdown, quotes and commands of LaTeX are left out,
 * - and _ within words are blanks, typographic and full-width characters are the plain ones;
 * `\boxed{X}` is read as "answer: (X)". */
AnswerTokens tokensOf(const std::string& answer);
}  // namespace voxeland
