// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/OptionList.h"

#include "voxeland/base/hiddenTexts.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/lowerCase.h"
#include "voxeland/base/nearestWord.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/printable.h"
#include "voxeland/base/trimmed.h"
#include "voxeland/plugins/Ini.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <ostream>
#include <sstream>

namespace voxeland
{
namespace
{
constexpr auto HIDDEN = "*";
constexpr double LEAST_MAGNITUDE = 1e-30;  // of a number that is not 0

/** Whether a text is no more than it seems: MRPT would put nothing else in its place, and a
 * terminal shows it. */
bool isPlain(const std::string& text)
{
    for (const char* begin : {"${", "$env{", "$eval{"})
        if (text.find(begin) != std::string::npos) return false;
    return isPrintable(text);
}

/** Where in a URL the name and password end with which to log in; npos: it has none. */
size_t endOfLogin(const std::string& url)
{
    return url.rfind('@');
}

bool isVariable(const std::string& name)
{
    return name.empty() || std::getenv(name.c_str()) != nullptr;
}

/** Reads "true" or "false"; returns what is wrong with the text, empty if nothing. */
std::string parseBool(const std::string& text, bool& variable)
{
    const std::string word = lowerCase(text);
    const bool yes = word == "true" || word == "yes" || word == "1";
    const bool no = word == "false" || word == "no" || word == "0";
    if (!yes && !no) return "is neither true nor false";
    variable = yes;
    return {};
}

std::vector<std::string> namesIn(const std::string& list)
{
    std::vector<std::string> names;
    std::istringstream in(list);
    for (std::string name; std::getline(in, name, ',');)
        if (name = trimmed(name); !name.empty()) names.push_back(name);
    return names;
}
}  // namespace

void OptionList::addText(const std::string& key, Printer print, Parser parse,
                         const std::string& comment)
{
    const std::string preset = print();
    m_options.push_back(
        {key, comment, std::move(print), std::move(parse), anyValue, false, m_forExperts, preset});
}

void OptionList::add(const std::string& key, std::string& variable, const std::string& comment,
                     OfMaps ofMaps)
{
    addText(
        key, [&variable] { return variable; },
        [&variable](const std::string& text) {
            if (!text.empty() && text.back() == '\\')
                return "ends with a backslash, by which a line goes on: leave it out";
            variable = text;
            return "";
        },
        comment);
    m_options.back().ofMaps = ofMaps;
    m_options.back().isText = true;
}

void OptionList::addUrl(const std::string& key, std::string& variable, const std::string& comment)
{
    add(key, variable, comment);
    Option& option = m_options.back();
    option.parse = [asText = option.parse](const std::string& text) -> std::string {
        const bool isHttp = text.rfind("http://", 0) == 0 || text.rfind("https://", 0) == 0;
        if (!isHttp || endOfLogin(text) != std::string::npos)
            return "is not of the form http[s]://host[:port]/path";
        return asText(text);
    };
    option.secret = [](const std::string& url) {
        const size_t end = endOfLogin(url);
        return end == std::string::npos ? "" : url.substr(0, end);
    };
}

void OptionList::addVariableName(const std::string& key, std::string& variable,
                                 const std::string& comment)
{
    addText(
        key, [&variable] { return isVariable(variable) ? variable : ""; },
        [&variable](const std::string& text) {
            const auto isOfNames = [](char c) {
                return c == '_' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                       (c >= 'a' && c <= 'z');
            };
            const bool beginsWithDigit = !text.empty() && text[0] >= '0' && text[0] <= '9';
            if (beginsWithDigit || !std::all_of(text.begin(), text.end(), isOfNames))
                return "must be the name of an environment variable, not the key: export the key "
                       "under a name, and give that name";
            variable = text;
            return "";
        },
        comment);
    m_options.back().ofMaps = noValue;
    m_options.back().isText = true;
    m_options.back().secret = [](const std::string& name) { return isVariable(name) ? "" : name; };
    concernsRun();
}

void OptionList::add(const std::string& key, bool& variable, const std::string& comment,
                     OfMaps ofMaps)
{
    addText(
        key, [&variable] { return variable ? "true" : "false"; },
        [&variable](const std::string& text) { return parseBool(text, variable); }, comment);
    m_options.back().ofMaps = ofMaps;
}

template <typename Number>
void OptionList::addNumber(const std::string& key, Number& variable, const Range& range,
                           const std::string& comment)
{
    addText(
        key, [&variable] { return numberText(static_cast<double>(variable)); },
        [&variable, range](const std::string& text) -> std::string {
            const double value = parsed<double>(trimmed(text)).value_or(NAN);
            if (!std::isfinite(value)) return "is not a number";
            if (value != 0 && std::abs(value) < LEAST_MAGNITUDE)
                return "is too close to 0 to be computed with: give 0, or " +
                       numberText(LEAST_MAGNITUDE) + " or more";
            if (std::numeric_limits<Number>::is_integer && value != std::floor(value))
                return "is not a whole number";
            if (!(value >= range.least && value <= range.most))
                return "is not within " + numberText(range.least) + " and " +
                       numberText(range.most);
            variable = static_cast<Number>(value);
            return {};
        },
        comment);
}

void OptionList::add(const std::string& key, int& variable, const Range& range,
                     const std::string& comment)
{
    addNumber(key, variable, range, comment);
}

void OptionList::add(const std::string& key, uint32_t& variable, const Range& range,
                     const std::string& comment)
{
    addNumber(key, variable, range, comment);
}

void OptionList::add(const std::string& key, double& variable, const Range& range,
                     const std::string& comment)
{
    addNumber(key, variable, range, comment);
}

void OptionList::addAblation(const std::vector<Part>& parts)
{
    std::vector<std::string> names;
    for (const Part& part : parts) names.push_back(part.name);
    addText(
        "ablation",
        [parts] {
            std::vector<std::string> unused;
            for (const Part& part : parts)
                if (!part.isUsed) unused.push_back(part.name);
            return joined(unused, ", ");
        },
        [parts, names](const std::string& text) -> std::string {
            const auto unused = namesIn(text);
            for (const std::string& name : unused)
                if (std::find(names.begin(), names.end(), name) == names.end())
                    return "has no part '" + name + "': there are " + joined(names, ", ");
            for (const Part& part : parts)
                part.isUsed = std::find(unused.begin(), unused.end(), part.name) == unused.end();
            return {};
        },
        "Parts of the method to leave out, to see what they are worth, of " + joined(names, ", "));
    for (const Part& part : parts) {
        if (part.formerKey.empty()) continue;
        add(part.formerKey, part.isUsed, "");
        m_options.back().isFormer = true;
    }
}

void OptionList::retire(const std::string& key)
{
    addText(
        key, [] { return std::string(); }, [](const std::string&) { return std::string(); }, "");
    m_options.back().isFormer = true;
}

void OptionList::load(const Ini& ini, const std::string& section,
                      std::vector<std::string>& problems)
{
    std::vector<std::string> known;
    for (const Option& o : m_options)
        if (!o.isFormer) known.push_back(o.key);
    for (const std::string& key : ini.keys(section)) {
        const auto isKey = [&](const std::string& name) {
            return lowerCase(name) == lowerCase(key);
        };
        const auto option = std::find_if(m_options.begin(), m_options.end(),
                                         [&](const Option& o) { return isKey(o.key); });
        if (option == m_options.end()) {
            const std::string nearest = nearestWord(key, known);
            problems.push_back("[" + section + "] has no key '" + key + "'" +
                               (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)"));
            continue;
        }
        const std::string value = ini.value(section, key);
        const std::string secret = option->secret(value);
        hideText(secret, HIDDEN);
        const std::string shown = secret.empty() ? value : HIDDEN + value.substr(secret.size());
        const bool isLeftToUser =
            ini.isOfMap(section, key) && (!option->ofMaps(value) || !isPlain(value));
        if (isLeftToUser) {
            if (value != option->print())
                m_leftToUser.push_back("[" + section + "] " + option->key + " = '" + shown + "'");
            continue;
        }
        const std::string wrong = option->parse(value);
        if (wrong.empty()) {
            option->printed = printedFor(*option, ini, section);
            continue;
        }
        problems.push_back("[" + section + "] " + option->key + " = '" + shown + "' " + wrong);
        if (value.find('#') != std::string::npos)
            problems.back() += " (comments behind a value start with ' //')";
    }
}

std::optional<std::string> OptionList::printedFor(const Option& option, const Ini& ini,
                                                  const std::string& section)
{
    const std::string value = ini.value(section, option.key);
    const auto written = ini.written(section, option.key);
    if (!option.isText || value == written) return std::nullopt;
    return written.value_or(option.ofMaps(value) ? value : "");
}

void OptionList::print(std::ostream& out, const std::string& section, Keys keys) const
{
    out << "[" << section << "]\n";
    for (const Option& o : m_options) {
        const bool isPreset = keys == Keys::ofMap && o.isOfRun;
        const std::string value = isPreset ? o.preset : o.printed.value_or(o.print());
        const bool isLeftOut = keys == Keys::common && o.isForExperts && value == o.preset;
        if (!o.isFormer && !isLeftOut)
            out << "# " << o.comment << "\n" << o.key << " = " << value << "\n";
    }
}
}  // namespace voxeland
