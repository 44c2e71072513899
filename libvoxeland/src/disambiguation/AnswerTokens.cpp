// SPDX-License-Identifier: BSD-3-Clause
#include "AnswerTokens.h"

#include <algorithm>

namespace voxeland
{
namespace
{
using Kind = AnswerToken::Kind;

constexpr bool isIn(char32_t c, char32_t first, char32_t last)
{
    return c >= first && c <= last;
}

/** Code points of a text in UTF-8; bytes that are none become blanks. */
std::u32string decoded(const std::string& text)
{
    std::u32string points;
    for (size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const size_t length = byte < 0x80   ? 1
                              : byte < 0xc0 ? 0
                              : byte < 0xe0 ? 2
                              : byte < 0xf0 ? 3
                                            : 4;
        char32_t point = length <= 1 ? byte : byte & (0x7fU >> length);
        bool isValid = length > 0 && i + length <= text.size();
        for (size_t k = 1; isValid && k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            isValid = (next & 0xc0U) == 0x80;
            point = point << 6U | (next & 0x3fU);
        }
        points += isValid ? point : U' ';
        i += isValid ? length : 1;
    }
    return points;
}

void append(std::string& text, char32_t point)
{
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    const auto putRest = [&](unsigned shift) { put(0x80 | (point >> shift & 0x3f)); };
    if (point < 0x80) {
        put(point);
    } else if (point < 0x800) {
        put(0xc0 | point >> 6);
        putRest(0);
    } else if (point < 0x10000) {
        put(0xe0 | point >> 12);
        putRest(6);
        putRest(0);
    } else {
        put(0xf0 | point >> 18);
        putRest(12);
        putRest(6);
        putRest(0);
    }
}

constexpr char32_t NOTHING = 0;

/** The plain character that a typographic or full-width one stands for, in lower case. */
char32_t plain(char32_t c)
{
    if (isIn(c, 0xff01, 0xff5e)) c -= 0xfee0;
    if (isIn(c, U'A', U'Z') || (isIn(c, 0xc0, 0xde) && c != 0xd7) || isIn(c, 0x391, 0x3a9) ||
        isIn(c, 0x410, 0x42f))
        return c + 0x20;
    if (isIn(c, 0x400, 0x40f)) return c + 0x50;
    if (isIn(c, 0x100, 0x17f) && !isIn(c, 0x138, 0x148)) return c | 1U;
    if (isIn(c, 0x200b, 0x200f) || isIn(c, 0x202a, 0x202e) || isIn(c, 0x2060, 0x2064) ||
        isIn(c, 0xfe00, 0xfe0f) || c == 0xfeff || c == 0xad)
        return NOTHING;
    if (c == 0x2028 || c == 0x2029 || c == 0x2022) return U'\n';
    if (c == 0x2010 || c == 0x2011) return U'-';
    if (isIn(c, 0x2018, 0x201b) || c == 0x2032 || c == 0x2bc) return U'\'';
    if (c == 0x3001 || c == 0xff64) return U',';
    if (c == 0x3002 || c == 0xff61 || c == 0x2026) return U'.';
    if (c == 0x2192) return U':';
    return c;
}

/** Whether every character is a word, as there are no blanks between words. */
bool isWithoutBlanks(char32_t c)
{
    return isIn(c, 0xe00, 0xeff) || isIn(c, 0x1100, 0x11ff) || isIn(c, 0x3040, 0x30ff) ||
           isIn(c, 0x3400, 0x9fff) || isIn(c, 0xac00, 0xd7af) || isIn(c, 0xf900, 0xfaff) ||
           isIn(c, 0x20000, 0x2fa1f);
}

bool isLetter(char32_t c)
{
    return isIn(c, U'a', U'z') || c == 0xaa || c == 0xb5 || c == 0xba ||
           (isIn(c, 0xc0, 0x1fff) && c != 0xd7 && c != 0xf7 && !isWithoutBlanks(c));
}

bool isDigit(char32_t c)
{
    return isIn(c, U'0', U'9');
}

/** Reads an answer from its beginning to its end. */
class Tokenizer
{
 public:
    explicit Tokenizer(const std::string& answer)
    {
        for (const char32_t c : decoded(answer))
            if (const char32_t p = plain(c); p != NOTHING) m_text += p;
    }

    AnswerTokens tokens()
    {
        for (m_at = 0; m_at < m_text.size(); ++m_at) read(m_text[m_at]);
        endWord();
        return std::move(m_tokens);
    }

 private:
    [[nodiscard]] char32_t character(size_t at) const
    {
        return at < m_text.size() ? m_text[at] : U' ';
    }
    [[nodiscard]] char32_t before() const { return m_at > 0 ? m_text[m_at - 1] : U' '; }

    void endWord()
    {
        if (!m_word.empty()) m_tokens.push_back({Kind::word, m_word});
        m_word.clear();
    }
    void add(Kind kind, const std::string& text)
    {
        endWord();
        m_tokens.push_back({kind, text});
    }
    void mark(char c) { add(Kind::mark, std::string(1, c)); }

    void read(char32_t c)
    {
        if (isLetter(c) || isDigit(c)) {
            append(m_word, c);
            return;
        }
        if (isWithoutBlanks(c)) {
            std::string word;
            append(word, c);
            add(Kind::word, word);
            return;
        }
        switch (c) {
            case U'\'':
                break;  // "isn't" is one word
            case U'.':
                readPoint();
                break;
            case U'<':
                readTag();
                break;
            case U'\\':
                readCommand();
                break;
            case U'-':
                // Of a compound, or of a list's line, unless there are words and blanks around it.
                if (before() == U' ' && character(m_at + 1) == U' ' && !m_tokens.empty() &&
                    m_tokens.back().isWord())
                    mark('-');
                endWord();
                break;
            default:
                endWord();
                if (const char c8 = markFor(c); c8 != ' ') mark(c8);
        }
    }

    static char markFor(char32_t c)
    {
        static constexpr std::u32string_view FROM = U"\n!;?,:=([{)]}/|&+";
        static constexpr std::string_view TO = "\n..?,::((()))/,//";
        if (isIn(c, 0x2012, 0x2015) || c == 0x2212) return '-';
        const size_t found = FROM.find(c);
        return found == std::u32string_view::npos ? ' ' : TO[found];
    }

    /** "0.9" and "T.V." go on. */
    void readPoint()
    {
        const char32_t next = character(m_at + 1);
        if (isDigit(before()) && isDigit(next)) return endWord();
        const bool isAbbreviation = m_word.size() == 1 && isLetter(before()) &&
                                    (isLetter(next) || (m_at >= 2 && character(m_at - 2) == U'.'));
        if (isAbbreviation) return endWord();
        mark('.');
    }

    void readTag()
    {
        constexpr size_t LONGEST = 40;
        const size_t end = m_text.find(U'>', m_at);
        const size_t other = m_text.find_first_of(U"<\n", m_at + 1);
        if (end == std::u32string::npos || end > other || end - m_at > LONGEST) return endWord();
        std::string inside;
        for (size_t i = m_at + 1; i < end; ++i) append(inside, m_text[i]);
        add(Kind::tag, inside);
        m_at = end;
    }

    /** A command of LaTeX. */
    void readCommand()
    {
        endWord();
        std::string name;
        for (; isIn(character(m_at + 1), U'a', U'z'); ++m_at) append(name, character(m_at + 1));
        if (name != "boxed" && name != "fbox") return;
        add(Kind::word, "answer");
        mark(':');
    }

    std::u32string m_text;
    size_t m_at = 0;
    std::string m_word;
    AnswerTokens m_tokens;
};
}  // namespace

AnswerTokens tokensOf(const std::string& answer)
{
    return Tokenizer(answer).tokens();
}
}  // namespace voxeland
