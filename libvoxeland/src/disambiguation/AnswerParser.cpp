// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/AnswerParser.h"

#include "CandidateNames.h"
#include "voxeland/disambiguation/Thoughts.h"

#include <algorithm>
#include <set>

namespace voxeland
{
namespace
{
using Words = std::set<std::string>;

/** What a statement is about. */
const Words SUBJECTS = {"category", "answer", "classification", "class", "label", "conclusion"};
/** What may stand between that and "is". */
const Words OF_THE_SUBJECT = {"of",    "for",      "the",   "this",  "that",     "object",
                              "in",    "question", "item",  "shown", "outlined", "here",
                              "would", "should",   "must",  "will",  "appears",  "seems",
                              "to",    "most",     "likely"};
const Words COPULAS = {"is", "be", "was"};
/** What a sentence about the object begins with, and goes on with. */
const Words PRONOUNS = {"it", "its", "this", "that", "thats", "object", "item", "thing"};
const Words LINKS = {"is", "be", "appears", "seems", "looks", "like", "must", "to"};
const Words OPENINGS = {"so",   "thus",     "therefore", "hence", "overall",  "yes",
                        "no",   "ok",       "okay",      "the",   "outlined", "clearly",
                        "wait", "actually", "however",   "sorry", "but",      "hmm"};
/** What may precede a name and says nothing. */
const Words FILLERS = {"a",         "an",         "the",       "most",       "likely",
                       "probably",  "definitely", "clearly",   "certainly",  "indeed",
                       "therefore", "thus",       "simply",    "just",       "to",
                       "be",        "best",       "described", "classified", "identified",
                       "labeled",   "labelled",   "named",     "called",     "as"};
const Words ARTICLES = {"a", "an", "the", "this", "that", "its", "some", "any"};
const Words NEGATIONS = {
    "not",   "no",     "isnt",   "arent",   "wasnt",        "neither",
    "nor",   "cannot", "cant",   "couldnt", "doesnt",       "dont",
    "never", "unlike", "than",   "instead", "excluding",    "except",
    "rule",  "rules",  "ruled",  "ruling",  "nicht",        "kein",
    "keine", "keinen", "pas",    "ni",      "non",          "geen",
    "niet",  "\u4e0d", "\u6ca1", "\u975e",  "\u043d\u0435", "\u043d\u0435\u0442"};
/** What makes of "not" something else. */
const Words ONLY = {"only", "just", "merely", "necessarily"};
const Words HEDGES = {"maybe",         "might",       "may",         "could",
                      "perhaps",       "possibly",    "either",      "whether",
                      "alternatively", "alternative", "alternatives"};
const Words CONNECTIVES = {"or", "and", "plus", "vs", "versus", "also", "even", "likely"};
const Words PLACES = {"on",     "in",    "at",   "near",    "beside", "behind",  "under",
                      "above",  "below", "over", "against", "around", "between", "beneath",
                      "inside", "by",    "from", "for",     "with",   "of",      "into"};
/** "to" is a place after these. */
const Words NEXT = {"next", "close", "adjacent", "attached", "belonging", "opposite"};
/** "of" and "with" are no places after these. */
const Words KINDS = {"type",  "kind",       "sort",    "piece",    "picture",   "image",
                     "photo", "photograph", "example", "category", "form",      "class",
                     "view",  "go",         "going",   "went",     "consistent"};
/** Other words that do not go on a name: what follows is about something else. */
const Words CLAUSES = {
    "because",     "as",         "since",     "that",        "which",       "who",
    "whose",       "where",      "when",      "while",       "whereas",     "although",
    "though",      "however",    "if",        "so",          "but",         "rather",
    "are",         "has",        "have",      "had",         "having",      "it",
    "these",       "those",      "there",     "here",        "i",           "we",
    "you",         "they",       "my",        "due",         "given",       "based",
    "considering", "judging",    "according", "thanks",      "owing",       "seen",
    "shown",       "visible",    "located",   "placed",      "standing",    "sitting",
    "made",        "used",       "featuring", "showing",     "fits",        "fit",
    "matches",     "appears",    "seems",     "looks",       "explanation", "reason",
    "reasoning",   "confidence", "score",     "probability", "note",        "without",
    "per",         "via",        "then",      "too",         "hence",       "one",
    "both",        "half",       "next",      "best",        "candidates",  "options",
    "categories",  "choices",    "would",     "bbox",        "is",          "was",
    "be",          "a",          "an",        "the",         "this",        "its",
    "to",          "therefore",  "thus"};
/** Marks at the end of a model's turn: it is not answering any more. */
const Words TURN_ENDS = {"/s",       "|im_end|",      "|eot_id|", "end_of_turn",
                         "|end|",    "|endoftext|",   "|return|", "eos",
                         "|eom_id|", "|end_of_text|", "|eot|",    "turn|"};

/** Where GLM begins what it is sure of. */
constexpr auto BOX = "|begin_of_box|";

bool isIn(const Words& words, const std::string& word)
{
    return words.count(word) > 0;
}

bool isNumber(const std::string& word)
{
    return std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/** Whether a word cannot be part of a name's description: "wooden" can, "because" cannot. */
bool isFunctionWord(const std::string& word)
{
    for (const Words* words : {&SUBJECTS, &NEGATIONS, &HEDGES, &CONNECTIVES, &PLACES, &CLAUSES})
        if (isIn(*words, word)) return true;
    return isNumber(word);
}

/** Replaces tags: a name by its words, an answer's by "answer:", others by the end of a line. */
AnswerTokens withoutTags(const AnswerTokens& tokens, const CandidateNames& names)
{
    using Kind = AnswerToken::Kind;
    AnswerTokens result;
    bool anyWord = false;
    size_t looked = 0;
    for (const AnswerToken& token : tokens) {
        if (token.kind != Kind::tag) {
            result.push_back(token);
            continue;
        }
        for (; looked < result.size(); ++looked) anyWord = anyWord || result[looked].isWord();
        if (anyWord && isIn(TURN_ENDS, token.text)) break;
        AnswerTokens meant = tokensOf(token.text);
        if (!names.contain(token.text)) {
            const bool isAnswers = token.text == BOX || (!meant.empty() && meant.front().isWord() &&
                                                         isIn(SUBJECTS, meant.back().text));
            meant = isAnswers ? AnswerTokens{{Kind::word, "answer"}, {Kind::mark, ":"}}
                              : AnswerTokens{{Kind::mark, "\n"}};
        }
        result.insert(result.end(), meant.begin(), meant.end());
    }
    return result;
}

/** What an answer says, rank by rank. */
class Reading
{
 public:
    Reading(AnswerTokens tokens, const CandidateNames& names)
        : m_tokens(std::move(tokens)), m_names(names)
    {
    }

    [[nodiscard]] std::optional<category_id_t> category() const
    {
        if (const auto claims = statements(); !claims.empty()) return agreed(claims);
        if (const auto claims = sentences(0); !claims.empty()) return agreed(claims);
        return namedAnywhere();
    }

 private:
    /** What a place in the text takes the object for. */
    struct Claim
    {
        enum Kind
        {
            nothing,  //!< no name begins here, and nothing else that could be one
            other,    //!< something that is no candidate, or several
            one       //!< a candidate
        };
        Kind kind = nothing;
        category_id_t category = UNKNOWN_CATEGORY_ID;
        size_t end = 0;  //!< token after it
    };
    using Claims = std::vector<Claim>;

    /** A name anywhere. */
    struct Mention
    {
        category_id_t category = UNKNOWN_CATEGORY_ID;
        bool isSure = false;       //!< the object is said to be that
        bool isUncertain = false;  //!< it may be that
    };

    [[nodiscard]] bool isWord(size_t at, const Words& words) const
    {
        return at < m_tokens.size() && m_tokens[at].isWord() && isIn(words, m_tokens[at].text);
    }
    [[nodiscard]] bool isMark(size_t at, const std::string& marks) const
    {
        return at < m_tokens.size() && !m_tokens[at].isWord() &&
               marks.find(m_tokens[at].text) != std::string::npos;
    }
    [[nodiscard]] bool isEnd(size_t at) const { return at >= m_tokens.size() || isMark(at, ".\n"); }
    [[nodiscard]] size_t skipped(size_t at, const Words& words) const
    {
        while (isWord(at, words)) ++at;
        return at;
    }

    /** The token after blank lines, brackets, fillers and "B)" or "2." */
    [[nodiscard]] size_t beginOfName(size_t at) const
    {
        for (;;) {
            const size_t before = at;
            while (isMark(at, "\n(:-)")) ++at;
            const bool isLabel = at < m_tokens.size() && m_tokens[at].isWord() &&
                                 (m_tokens[at].text.size() == 1 || isNumber(m_tokens[at].text)) &&
                                 isMark(at + 1, ").:");
            if (isLabel) at += 2;
            if (!m_names.at(m_tokens, at)) at = skipped(at, FILLERS);
            if (at == before) return at;
        }
    }

    /** Where the object is named after what it is not: "not a chair but a couch". */
    [[nodiscard]] size_t afterDenial(size_t at) const
    {
        static const Words BUT = {"but", "rather"};
        while (!isEnd(at) && !isWord(at, BUT) && !isMark(at, ",")) ++at;
        while (isMark(at, ",") || isWord(at, BUT) || isWord(at, PRONOUNS) || isWord(at, COPULAS))
            ++at;
        return at;
    }

    [[nodiscard]] bool endsName(size_t at) const
    {
        if (at >= m_tokens.size()) return true;
        return m_tokens[at].isWord() ? isFunctionWord(m_tokens[at].text) : !isMark(at, "?");
    }

    /** A name alone, with what describes it, and no regard to what follows. */
    [[nodiscard]] Claim nameAt(size_t at) const
    {
        constexpr size_t MOST_ADJECTIVES = 3;
        at = beginOfName(at);
        const size_t first = at;
        for (; at <= first + MOST_ADJECTIVES; ++at) {
            if (const auto match = m_names.at(m_tokens, at)) {
                const size_t end = at + match->tokens;
                return {endsName(end) ? Claim::one : Claim::other, match->category, end};
            }
            if (at >= m_tokens.size() || !m_tokens[at].isWord() ||
                isFunctionWord(m_tokens[at].text))
                break;
        }
        const bool isSentence = isWord(at, SUBJECTS) || isWord(at, LINKS);
        const bool isSomething = at > first && !isSentence;
        return {isSomething ? Claim::other : Claim::nothing, UNKNOWN_CATEGORY_ID, at};
    }

    /** Whether a token may stand between names of a list. */
    [[nodiscard]] bool isJoint(size_t at) const
    {
        return isMark(at, ",/()-:") || isWord(at, CONNECTIVES) || isWord(at, HEDGES);
    }

    /** Whether what follows a name takes the object for something else as well. */
    [[nodiscard]] bool isOneOfSeveral(const Claim& claim) const
    {
        bool isChoice = false;
        size_t at = claim.end;
        for (; isJoint(at); ++at) isChoice = isChoice || isWord(at, {"or"}) || isWord(at, HEDGES);
        if (at == claim.end) return false;
        const Claim next = nameAt(at);
        const bool isOther = next.kind == Claim::other
                                 ? isChoice || m_names.at(m_tokens, at)
                                 : next.kind == Claim::one && next.category != claim.category;
        return isOther || (isChoice && next.kind == Claim::nothing);
    }

    [[nodiscard]] Claim claimAt(size_t at) const
    {
        at = beginOfName(at);
        if (isWord(at, NEGATIONS) && !m_names.at(m_tokens, at)) {
            if (isWord(at + 1, ONLY)) return {Claim::other, UNKNOWN_CATEGORY_ID, at};
            at = afterDenial(at);
        }
        Claim claim = nameAt(at);
        if (claim.kind == Claim::one && isOneOfSeveral(claim)) claim.kind = Claim::other;
        return claim;
    }

    /** The token after "category is" or "answer:"; none if no such statement begins here. */
    [[nodiscard]] std::optional<size_t> afterStatement(size_t at) const
    {
        if (!isWord(at, SUBJECTS)) return std::nullopt;
        at = skipped(at + 1, OF_THE_SUBJECT);
        if (isWord(at, COPULAS) || isMark(at, ":-")) return at + 1;
        return std::nullopt;
    }

    /** What statements claim; those from the first "final answer" on if there is one. */
    [[nodiscard]] Claims statements() const
    {
        Claims all, final;
        bool isFinal = false;
        for (size_t at = 0; at < m_tokens.size(); ++at) {
            isFinal = isFinal || (isWord(at, {"final"}) && isWord(at + 1, SUBJECTS));
            const auto start = afterStatement(at);
            if (!start) continue;
            const Claim claim = claimAt(*start);
            if (claim.kind == Claim::nothing) continue;
            all.push_back(claim);
            if (isFinal) final.push_back(claim);
        }
        return final.empty() ? all : final;
    }

    /** What sentences from a token on claim that are a name, or say "it is" one. */
    [[nodiscard]] Claims sentences(size_t at) const
    {
        Claims claims;
        for (; at < m_tokens.size(); ++at) {
            if (at > 0 && !isEnd(at - 1) && !isMark(at - 1, ":")) continue;
            size_t pronoun = at;
            while (isWord(pronoun, OPENINGS) || isMark(pronoun, ",")) ++pronoun;
            const size_t link = pronoun + 1;
            const bool isAbout = isWord(pronoun, {"its", "thats"}) ||
                                 (isWord(pronoun, PRONOUNS) && isWord(link, LINKS));
            const Claim claim = claimAt(isAbout ? skipped(link, LINKS) : at);
            if (claim.kind != Claim::one) continue;
            if (isAbout || isEnd(claim.end)) claims.push_back(claim);
        }
        return claims;
    }

    /** The category of all claims, unless they differ or what follows the last one makes it one of
     * several. */
    [[nodiscard]] std::optional<category_id_t> agreed(const Claims& claims) const
    {
        for (const Claim& c : claims)
            if (c.kind != Claim::one || c.category != claims.front().category) return std::nullopt;
        const Claim& last = claims.back();
        for (const Claim& c : sentences(last.end))
            if (c.category != last.category) return std::nullopt;
        for (const Mention& m : mentions(last.end))
            if (m.isUncertain && m.category != last.category) return std::nullopt;
        return last.category;
    }

    /** Whether the name at a token only says where the object is: "on a wooden NAME". */
    [[nodiscard]] bool isPlace(size_t at) const
    {
        constexpr size_t MOST_ADJECTIVES = 2;
        for (size_t adjectives = 0; at > 0 && adjectives <= MOST_ADJECTIVES;) {
            --at;
            if (!m_tokens[at].isWord()) return false;
            const bool isOfKind = at > 0 && isWord(at - 1, KINDS);
            if (isWord(at, PLACES)) return !isOfKind;
            if (isWord(at, {"to"})) return at > 0 && isWord(at - 1, NEXT);
            if (isWord(at, ARTICLES)) continue;
            if (isFunctionWord(m_tokens[at].text)) return false;
            ++adjectives;
        }
        return false;
    }

    /** All names from a token on that are not denied and no place. */
    [[nodiscard]] std::vector<Mention> mentions(size_t at) const
    {
        std::vector<Mention> all;
        bool isDenied = false, isHedged = false, wasPlace = false;
        size_t list = at;  // to where the names so far are one list
        while (at < m_tokens.size()) {
            if (isMark(at, ".\n?")) isHedged = false;
            if (!m_tokens[at].isWord() || isWord(at, {"but"})) isDenied = false;
            isHedged = isHedged || isWord(at, HEDGES) || (isDenied && isWord(at, ONLY));
            const auto match = m_names.at(m_tokens, at);
            if (!match) {
                isDenied = isDenied || isWord(at, NEGATIONS);
                ++at;
                continue;
            }
            const size_t end = at + match->tokens;
            const Claim claim{Claim::one, match->category, end};
            wasPlace = isPlace(at) || (wasPlace && list == at);
            if (!isDenied && !wasPlace)
                all.push_back({match->category,
                               !isHedged && endsName(end) && !isOneOfSeveral(claim),
                               isHedged || isWord(end, {"or"}) || isMark(end, "?")});
            at = list = end;
            while (isJoint(list) || isWord(list, ARTICLES)) ++list;
        }
        return all;
    }

    [[nodiscard]] std::optional<category_id_t> namedAnywhere() const
    {
        const auto all = mentions(0);
        const bool anySure =
            std::any_of(all.begin(), all.end(), [](const Mention& m) { return m.isSure; });
        for (const Mention& m : all)
            if (m.category != all.front().category) return std::nullopt;
        if (!anySure) return std::nullopt;
        return all.front().category;
    }

    AnswerTokens m_tokens;
    const CandidateNames& m_names;
};
}  // namespace

std::optional<category_id_t> categoryNamedBy(const std::string& answer,
                                             const std::vector<RankedCategory>& candidates)
{
    const CandidateNames names(candidates);
    std::string text = withoutThoughts(answer);
    if (text.size() > LONGEST_ANSWER) text.erase(0, text.size() - LONGEST_ANSWER);
    return Reading(withoutTags(tokensOf(text), names), names).category();
}
}  // namespace voxeland
