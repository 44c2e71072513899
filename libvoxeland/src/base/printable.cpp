// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/printable.h"

#include "voxeland/base/hiddenTexts.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace voxeland
{
namespace
{
/** A character of UTF-8, or one byte that is part of none. */
struct Character
{
    std::string_view bytes;
    uint32_t code;
    bool valid;
};

/** The first character of a text that is not empty. */
Character firstOf(std::string_view text)
{
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
    const uint8_t first = byte(0);
    const Character none{text.substr(0, 1), first, false};
    if (first < 0x80) return {text.substr(0, 1), first, true};
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return none;
    uint32_t code = first & (0xFFU >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return none;
        code = code << 6 | (byte(i) & 0x3FU);
    }
    constexpr uint32_t LEAST[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < LEAST[length] || code > 0x10FFFF || surrogate) return none;
    return {text.substr(0, length), code, true};
}

/** Whether a character does something instead of being something: controls, ends of lines and
 *  paragraphs, marks and overrides of the direction of writing, what has no width. */
bool actsUnseen(uint32_t code)
{
    constexpr std::pair<uint32_t, uint32_t> RANGES[] = {
        {0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},     {0x61C, 0x61C},   {0x200B, 0x200B},
        {0x200E, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F}, {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}};
    return std::any_of(std::begin(RANGES), std::end(RANGES), [code](const auto& range) {
        return code >= range.first && code <= range.second;
    });
}

/** A character as it is shown. */
std::string shown(const Character& c)
{
    if (c.valid && !actsUnseen(c.code)) return std::string(c.bytes);
    if (c.code == '\n') return "\\n";
    if (c.code == '\r') return "\\r";
    if (c.code == '\t') return "\\t";
    char escaped[12];
    const char* pattern = !c.valid || c.code < 0x20 ? "\\x%02x" : "\\u%04x";
    std::snprintf(escaped, sizeof(escaped), pattern, c.code);
    return escaped;
}

/** How many places on a line that takes. */
size_t widthOf(const std::string& piece)
{
    const bool isCharacter = static_cast<uint8_t>(piece[0]) >= 0x80;
    return isCharacter ? 1 : piece.size();
}

/** The begin of a text. */
struct Begin
{
    std::string shown;
    size_t bytes = 0;  //!< of the text that it shows
};

Begin beginOf(std::string_view text, size_t width)
{
    Begin begin;
    while (begin.bytes < text.size()) {
        const Character next = firstOf(text.substr(begin.bytes));
        const std::string piece = shown(next);
        if (widthOf(piece) > width) break;
        width -= widthOf(piece);
        begin.shown += piece;
        begin.bytes += next.bytes.size();
    }
    return begin;
}

std::string endOf(std::string_view text, size_t width)
{
    constexpr size_t LONGEST = 4;  // bytes of a character
    text.remove_prefix(text.size() - std::min(text.size(), width * LONGEST));
    for (size_t i = 1; i < LONGEST && !text.empty() && (text[0] & 0xC0) == 0x80; ++i)
        text.remove_prefix(1);
    std::vector<std::string> pieces;
    for (; !text.empty(); text.remove_prefix(firstOf(text).bytes.size()))
        pieces.push_back(shown(firstOf(text)));
    std::string end;
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
        if (widthOf(*piece) > width) break;
        width -= widthOf(*piece);
        end.insert(0, *piece);
    }
    return end;
}

/** printable() of a text of which nothing is to be hidden any more. */
std::string cutTo(size_t maxLength, std::string_view text)
{
    constexpr size_t LEAST = 8;
    const std::string between = "...";
    maxLength = std::max(maxLength, LEAST);
    const Begin begin = beginOf(text, maxLength);
    if (begin.bytes == text.size()) return begin.shown;
    const size_t lengthOfEnd = maxLength / 3;
    return beginOf(text, maxLength - between.size() - lengthOfEnd).shown + between +
           endOf(text, lengthOfEnd);
}
}  // namespace

std::string printable(std::string_view text, size_t maxLength)
{
    return cutTo(maxLength, withoutHidden(text));
}

bool isPrintable(std::string_view text)
{
    return beginOf(text, UNCUT).shown == text;
}

std::string printableSentence(std::string_view sentenceOfAny, size_t maxLength)
{
    constexpr size_t LONG_WORD = 60;
    const std::string harmless = withoutHidden(sentenceOfAny);
    std::string_view text = harmless;
    const Begin begin = beginOf(text, maxLength);
    if (begin.bytes == text.size()) return begin.shown;
    std::string sentence;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        sentence += cutTo(LONG_WORD, word);
        text.remove_prefix(word.size());
        for (; !text.empty() && text[0] == ' '; text.remove_prefix(1)) sentence += ' ';
    }
    return cutTo(maxLength, sentence);
}
}  // namespace voxeland
