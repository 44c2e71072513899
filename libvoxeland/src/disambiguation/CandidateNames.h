// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "AnswerTokens.h"
#include "voxeland/map/MapQueries.h"

#include <optional>
#include <vector>

namespace voxeland
{
/** The names that an answer may give, and how they may be written: in any case, with blanks, - or _
 * or nothing between their words, in the singular or plural. */
class CandidateNames
{
 public:
    explicit CandidateNames(const std::vector<RankedCategory>& candidates);

    /** A name found in an answer. */
    struct Match
    {
        category_id_t category = UNKNOWN_CATEGORY_ID;
        size_t tokens = 0;  //!< how many it takes
    };
    /** The name that begins at a token, the longest one. */
    [[nodiscard]] std::optional<Match> at(const AnswerTokens& tokens, size_t first) const;
    /** Whether a text is a name and nothing else. */
    [[nodiscard]] bool contain(const std::string& text) const;

 private:
    struct Name
    {
        std::string letters;    //!< its words without anything between
        bool hasMarks = false;  //!< whether something like / parts its words
        category_id_t category;
    };
    void add(const std::string& name, category_id_t category);

    std::vector<Name> m_names;
};
}  // namespace voxeland
