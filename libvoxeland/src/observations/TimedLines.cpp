// SPDX-License-Identifier: BSD-3-Clause
#include "TimedLines.h"

#include "files/TextFile.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

namespace voxeland
{
namespace
{
constexpr const char* BLANKS = " \t;";
constexpr const char* SEPARATORS = " \t;,";

std::vector<std::string> words(const std::string& text, const char* separators)
{
    std::vector<std::string> found;
    for (size_t end = 0;;) {
        const size_t begin = text.find_first_not_of(separators, end);
        if (begin == std::string::npos) return found;
        end = std::min(text.find_first_of(separators, begin), text.size());
        found.push_back(text.substr(begin, end - begin));
    }
}

bool isNumberWithComma(const std::string& word)
{
    const size_t comma = word.find(',');
    return comma != std::string::npos && parsed<double>(word.substr(0, comma)) &&
           parsed<uint64_t>(word.substr(comma + 1));
}

bool hasDecimalComma(const std::string& text)
{
    const auto found = words(text, BLANKS);
    return found.size() > 1 && std::any_of(found.begin(), found.end(), isNumberWithComma);
}

/** What stands behind the time. */
std::string withoutSeparator(const std::string& text)
{
    const std::string rest = trimmed(text);
    const bool separated = !rest.empty() && (rest[0] == ',' || rest[0] == ';');
    return separated ? trimmed(rest.substr(1)) : rest;
}

/** The titles of columns: words between commas or semicolons, where there are any. */
std::vector<std::string> titlesIn(const std::string& text)
{
    const bool separated = text.find_first_of(",;") != std::string::npos;
    std::vector<std::string> titles = words(text, separated ? ",;" : " \t");
    for (std::string& title : titles) title = trimmed(title);
    return titles;
}

/** A time's unit, which the numbers themselves tell where they are too great for seconds. */
struct Unit
{
    double from;    //!< least number
    double second;  //!< of these in a second
    const char* name;
};
constexpr Unit UNITS[] = {
    {1e17, 1e9, "nanoseconds"}, {1e14, 1e6, "microseconds"}, {1e11, 1e3, "milliseconds"}};

void convertTimes(TimedLines& file)
{
    double greatest = 0;
    for (const TimedLine& line : file.lines) greatest = std::max(greatest, std::abs(line.time));
    for (const Unit& unit : UNITS) {
        if (greatest < unit.from) continue;
        for (TimedLine& line : file.lines) line.time /= unit.second;
        file.notes.push_back("the times of " + file.name + " are read as " + unit.name);
        return;
    }
}
}  // namespace

std::vector<std::string> separatedWords(const std::string& text)
{
    return words(text, SEPARATORS);
}

std::string TimedLines::where(const TimedLine& line) const
{
    return "line " + std::to_string(line.number) + " of " + name;
}

TimedLines TimedLines::fromFile(const std::string& file, const std::string& name,
                                const std::string& form, bool strict)
{
    constexpr double MOST = 1e20;
    std::istringstream in(readTextFile(file, "text of lines '" + form + "'"));
    TimedLines result{name, {}, {}, LeftOut(strict), {}};
    size_t number = 0;
    bool mayBeTitles = true;
    for (std::string text; std::getline(in, text);) {
        ++number;
        text = trimmed(text);
        if (text.empty()) continue;
        if (text[0] == '#') {
            if (mayBeTitles) result.titles = titlesIn(text.substr(1));
            continue;
        }
        const std::string word = text.substr(0, text.find_first_of(SEPARATORS));
        const auto time = parsed<double>(word);
        const TimedLine line{number, time.value_or(0), withoutSeparator(text.substr(word.size()))};
        const bool isFirst = std::exchange(mayBeTitles, false);
        const bool isWord = std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '%';
        if (isFirst && !time && isWord) {
            result.titles = titlesIn(text);
            continue;
        }
        if (hasDecimalComma(text))
            throw InputError(result.where(line) +
                             " has numbers with decimal commas: write 1.5 for 1,5");
        if (time && std::abs(*time) < MOST && !line.rest.empty())
            result.lines.push_back(line);
        else
            result.leftOut.add(result.where(line) + " is not '" + form + "'");
    }
    if (result.lines.empty() && result.leftOut.count() > 0)
        throw InputError(result.leftOut.first());
    convertTimes(result);
    return result;
}
}  // namespace voxeland
