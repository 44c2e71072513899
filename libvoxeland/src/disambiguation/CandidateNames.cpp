// SPDX-License-Identifier: BSD-3-Clause
#include "CandidateNames.h"

#include "base/plural.h"

#include <algorithm>

namespace voxeland
{
CandidateNames::CandidateNames(const std::vector<RankedCategory>& candidates)
{
    for (const RankedCategory& c : candidates) add(c.name, c.category);
    for (const char* name : {UNKNOWN_CATEGORY, "none", "none of these", "none of those",
                             "none of them", "none of the above"})
        add(name, UNKNOWN_CATEGORY_ID);
}

void CandidateNames::add(const std::string& name, category_id_t category)
{
    Name added{"", false, category};
    for (const AnswerToken& token : tokensOf(name)) {
        if (token.isWord())
            added.letters += token.text;
        else
            added.hasMarks = true;
    }
    if (!added.letters.empty()) m_names.push_back(added);
}

std::optional<CandidateNames::Match> CandidateNames::at(const AnswerTokens& tokens,
                                                        size_t first) const
{
    if (first >= tokens.size() || !tokens[first].isWord()) return std::nullopt;
    std::optional<Match> best;
    bool isBestExact = false;
    for (const Name& name : m_names) {
        std::string letters;
        for (size_t i = first; i < tokens.size() && letters.size() < name.letters.size(); ++i) {
            if (!tokens[i].isWord() && !name.hasMarks) break;
            if (!tokens[i].isWord()) continue;
            letters += tokens[i].text;
            const bool isExact = letters == name.letters;
            if (!isExact && !isPluralOf(letters, name.letters) &&
                !isPluralOf(name.letters, letters))
                continue;
            const size_t length = i - first + 1;
            if (best && (length < best->tokens || (length == best->tokens && isBestExact)))
                continue;
            best = Match{name.category, length};
            isBestExact = isExact;
        }
    }
    return best;
}

bool CandidateNames::contain(const std::string& text) const
{
    const AnswerTokens tokens = tokensOf(text);
    const auto match = at(tokens, 0);
    return match && match->tokens == tokens.size();
}
}  // namespace voxeland
