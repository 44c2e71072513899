// SPDX-License-Identifier: BSD-3-Clause
#include "YamlNames.h"

#include "voxeland/base/errors.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <sstream>

namespace voxeland
{
namespace
{
const std::string KEY = "names:";

/** A YAML text without what is behind a '#' that is not in quotes. */
std::string withoutComment(const std::string& line)
{
    char quote = '\0';
    for (size_t i = 0; i < line.size(); ++i) {
        if (quote == '\0' && (line[i] == '"' || line[i] == '\''))
            quote = line[i];
        else if (line[i] == quote)
            quote = '\0';
        else if (line[i] == '#' && quote == '\0' && (i == 0 || line[i - 1] == ' '))
            return line.substr(0, i);
    }
    return line;
}

/** What a scalar says, without its quotes. */
std::string scalar(const std::string& text)
{
    std::string word = trimmed(text);
    if (word.size() >= 2 && (word[0] == '"' || word[0] == '\'') && word.back() == word[0])
        word = word.substr(1, word.size() - 2);
    return trimmed(word);
}

/** Collects names, entry after entry. */
class NamesInYaml
{
 public:
    explicit NamesInYaml(const std::string& source) : m_source(source) {}

    /** \param entry "- name" in a line of its own, or "number: name" */
    void addLine(const std::string& entry, size_t line)
    {
        if (entry.front() == '-')
            add(m_next, entry.substr(1), line);
        else
            addPair(entry, line);
    }

    /** \param list what is between brackets: "name, name" or "number: name, number: name" */
    void addInBrackets(const std::string& list, bool arePairs, size_t line)
    {
        std::string entry;
        char quote = '\0';
        const auto flush = [&] {
            if (!trimmed(entry).empty()) arePairs ? addPair(entry, line) : add(m_next, entry, line);
            entry.clear();
        };
        for (const char c : list) {
            if (quote == '\0' && (c == '"' || c == '\''))
                quote = c;
            else if (c == quote)
                quote = '\0';
            if (c == ',' && quote == '\0')
                flush();
            else
                entry += c;
        }
        flush();
    }

    [[noreturn]] void fail(size_t line, const std::string& problem) const
    {
        throw InputError("line " + std::to_string(line) + " of " + m_source + " " + problem);
    }

    [[nodiscard]] const CategoryNames& names() const { return m_names; }

 private:
    void addPair(const std::string& entry, size_t line)
    {
        const size_t colon = entry.find(':');
        const auto number = parsed<int64_t>(scalar(entry.substr(0, colon)));
        if (colon == std::string::npos || !number)
            fail(line, "is neither '- name' nor 'number: name'");
        add(*number, entry.substr(colon + 1), line);
    }

    void add(int64_t number, const std::string& text, size_t line)
    {
        const std::string name = scalar(text);
        if (name.empty()) fail(line, "gives no name to category " + std::to_string(number));
        if (!m_names.emplace(number, name).second)
            fail(line, "names category " + std::to_string(number) + " twice");
        m_next = number + 1;
    }

    const std::string& m_source;
    CategoryNames m_names;
    int64_t m_next = 0;
};

/** Names in brackets that begin in a line, to their end there or in a line below. */
void readBrackets(std::string list, std::istringstream& lines, size_t& number, NamesInYaml& names)
{
    const char closing = list.front() == '[' ? ']' : '}';
    const size_t first = number;
    std::string line;
    while (list.find(closing) == std::string::npos) {
        if (!std::getline(lines, line)) names.fail(first, "has brackets that do not end");
        ++number;
        list += " " + trimmed(withoutComment(line));
    }
    names.addInBrackets(list.substr(1, list.rfind(closing) - 1), closing == '}', first);
}
}  // namespace

std::optional<CategoryNames> namesFromYaml(const std::string& text, const std::string& source)
{
    std::istringstream lines(text);
    NamesInYaml names(source);
    bool inside = false;
    size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        line = withoutComment(line);
        const std::string entry = trimmed(line);
        if (entry.empty()) continue;
        const bool isKey = line.compare(0, KEY.size(), KEY) == 0;
        if (inside && (line.front() == ' ' || line.front() == '\t' || line.front() == '-'))
            names.addLine(entry, number);
        else if (inside)
            break;
        if (!isKey) continue;
        inside = true;
        const std::string rest = trimmed(entry.substr(KEY.size()));
        if (rest.empty()) continue;
        if (rest.front() != '[' && rest.front() != '{')
            names.fail(number, "is not followed by names");
        readBrackets(rest, lines, number, names);
        break;
    }
    return inside ? std::optional(names.names()) : std::nullopt;
}
}  // namespace voxeland
