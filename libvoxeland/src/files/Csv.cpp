// SPDX-License-Identifier: BSD-3-Clause
#include "Csv.h"

#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <string_view>

namespace voxeland
{
namespace
{
[[noreturn]] void fail(size_t line, const std::string& source, const std::string& problem)
{
    throw InputError("line " + std::to_string(line) + " of " + source + " " + problem);
}

/** Bytes of the UTF-8 character that begins a text; 0 if it is none. */
size_t characterLength(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    const size_t length = first < 0x80                    ? 1
                          : first >= 0xC2 && first < 0xE0 ? 2
                          : first >= 0xE0 && first < 0xF0 ? 3
                          : first >= 0xF0 && first < 0xF5 ? 4
                                                          : 0;
    if (text.size() < length) return 0;
    const auto goesOn = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    return std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), goesOn)
               ? length
               : 0;
}

void checkUtf8(std::string_view text, const std::string& source)
{
    for (size_t line = 1; !text.empty();) {
        const size_t length = characterLength(text);
        if (length == 0) fail(line, source, "is not UTF-8 text: save the file as UTF-8");
        if (text.front() == '\n') ++line;
        text.remove_prefix(length);
    }
}

const std::string SEPARATOR_IS = "sep=";

/** Whether the first line is "sep=;", which tells spreadsheets what separates. */
bool tellsSeparator(const std::string& text)
{
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    return text.compare(0, SEPARATOR_IS.size(), SEPARATOR_IS) == 0 &&
           end == SEPARATOR_IS.size() + 1;
}

/** What separates the fields of a table. */
char separatorOf(const std::string& text)
{
    if (tellsSeparator(text)) return text[SEPARATOR_IS.size()];
    const size_t start = text.find_first_not_of(" \r\n");
    if (start == std::string::npos) return ',';
    bool quoted = false;
    std::string found;
    for (size_t i = start; i < text.size() && (quoted || text[i] != '\n'); ++i) {
        if (text[i] == '"') quoted = !quoted;
        if (!quoted) found += text[i];
    }
    for (const char c : {'\t', ';'})
        if (found.find(c) != std::string::npos) return c;
    return ',';
}

/** Takes a table apart, from its beginning to its end. */
class CsvParser
{
 public:
    CsvParser(const std::string& text, const std::string& source)
        : m_rest(text), m_source(source), m_separator(separatorOf(text))
    {
        if (tellsSeparator(text)) m_rest.remove_prefix(SEPARATOR_IS.size() + 1);
    }

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }

    CsvRow row()
    {
        CsvRow row{m_line, {field()}};
        while (taken(m_separator)) row.fields.push_back(field());
        if (taken('\n')) ++m_line;
        return row;
    }

 private:
    std::string field()
    {
        const size_t blanks = std::min(m_rest.find_first_not_of(' '), m_rest.size());
        if (blanks < m_rest.size() && m_rest[blanks] == '"') {
            m_rest.remove_prefix(blanks + 1);
            return quoted();
        }
        return trimmed(unquoted());
    }

    std::string unquoted()
    {
        const char ends[] = {m_separator, '\n', '\0'};
        const auto text = m_rest.substr(0, m_rest.find_first_of(ends));
        m_rest.remove_prefix(text.size());
        return std::string(text);
    }

    /** From behind the quotes that begin it. */
    std::string quoted()
    {
        const size_t firstLine = m_line;
        std::string text;
        for (;;) {
            const size_t end = m_rest.find('"');
            if (end == std::string_view::npos)
                fail(firstLine, m_source, "has a field whose quotes do not end");
            text += m_rest.substr(0, end);
            m_line += static_cast<size_t>(std::count(
                m_rest.begin(), m_rest.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            m_rest.remove_prefix(end + 1);
            if (!taken('"')) break;
            text += '"';
        }
        if (!trimmed(unquoted()).empty())
            fail(firstLine, m_source, "has more behind the quotes of a field");
        return trimmed(text);
    }

    bool taken(char c)
    {
        if (m_rest.empty() || m_rest.front() != c) return false;
        m_rest.remove_prefix(1);
        return true;
    }

    std::string_view m_rest;
    const std::string& m_source;
    char m_separator;
    size_t m_line = 1;
};

bool isBlank(const CsvRow& row)
{
    return row.fields.size() == 1 && row.fields.front().empty();
}
}  // namespace

std::vector<CsvRow> parseCsv(const std::string& text, const std::string& source)
{
    checkUtf8(text, source);
    std::vector<CsvRow> rows;
    for (CsvParser parser(text, source); !parser.atEnd();) {
        rows.push_back(parser.row());
        if (isBlank(rows.back())) rows.pop_back();
    }
    return rows;
}

std::vector<CsvRow> parseCsv(const std::string& text, const std::vector<std::string>& header,
                             const std::string& source)
{
    auto rows = parseCsv(text, source);
    if (rows.empty() || rows.front().fields != header)
        throw InputError(source + " must begin with the line '" + joined(header, ",") + "'.");
    rows.erase(rows.begin());
    for (const CsvRow& row : rows)
        if (row.fields.size() != header.size())
            fail(row.line, source,
                 "has " + counted(row.fields.size(), "field") + " instead of " +
                     std::to_string(header.size()) + ".");
    return rows;
}

std::string csvField(const std::string& text)
{
    if (text.find_first_of(",;\t\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}
}  // namespace voxeland
