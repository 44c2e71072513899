// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/Ini.h"

#include "base/ClassicNumbers.h"
#include "files/TextFile.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/hiddenTexts.h"
#include "voxeland/base/lowerCase.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>

namespace voxeland
{
namespace
{
std::string firstLine(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

/** plainText() with '\n' alone at the end of each line. */
std::string plainLines(std::string text)
{
    text = plainText(std::move(text));
    text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
    return text;
}

bool holdsControls(const std::string& text)
{
    return std::any_of(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n') || c == '\x7F';
    });
}

using Identity = std::pair<std::string, std::string>;

/** What identifies a key: MRPT makes no difference between large and small letters. */
Identity identity(const std::string& section, const std::string& key)
{
    return {lowerCase(section), lowerCase(key)};
}

/** Whether MRPT's parser understands a line that begins with '@'. */
bool isDefinition(const std::string& line)
{
    std::istringstream words(line);
    std::string directive, variable;
    return words >> directive >> variable && directive == "@define";
}

/** MRPT's parser passes over what it does not understand, and over all but the last of values for
 * one key; this does not. */
void checkLines(const std::string& text, const std::string& origin)
{
    std::istringstream in(text);
    bool continued = false;
    size_t number = 0;
    std::string section;
    std::map<Identity, size_t> lines;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (holdsControls(line))
            throw ConfigurationError("line " + std::to_string(number) + " of '" + origin +
                                     "' holds control characters: is it an INI?");
        const std::string words = trimmed(line);
        const bool follows = std::exchange(continued, !words.empty() && words.back() == '\\');
        if (words.empty() || follows) continue;
        if (words[0] == '[') section = trimmed(words.substr(1, words.find(']') - 1));
        if (words[0] == '@' && !isDefinition(words))
            throw ConfigurationError("line " + std::to_string(number) + " of '" + origin +
                                     "' begins with '@' but is not '@define NAME VALUE'");
        const bool special = std::string("#;[@").find(words[0]) != std::string::npos;
        if (special || words.compare(0, 2, "//") == 0) continue;
        const size_t equals = line.find('=');
        if (equals == std::string::npos)
            throw ConfigurationError("line " + std::to_string(number) + " of '" + origin +
                                     "' is neither '[section]' nor 'key = value'");
        const std::string key = trimmed(line.substr(0, equals));
        const auto [known, isNew] = lines.emplace(identity(section, key), number);
        if (!isNew)
            throw ConfigurationError("line " + std::to_string(number) + " of '" + origin +
                                     "' gives [" + section + "] " + key + " again: line " +
                                     std::to_string(known->second) + " does too; keep one");
    }
}

using Content = mrpt::config::CConfigFileMemory;

/** What MRPT finds wrong, in a sentence, without the text that it quotes: variables of the
 * environment may be expanded in it. */
std::string reasonOf(const std::string& text, const std::string& origin,
                     const std::string& complaint)
{
    static const std::string EXPRESSION = "Error compiling expression (name=`Line ";
    const size_t found = complaint.find(EXPRESSION);
    if (found == std::string::npos)
        return "'" + origin +
               "' is not a valid INI: " + firstLine(complaint.substr(0, complaint.find(" near: ")));
    const size_t number = std::strtoul(complaint.c_str() + found + EXPRESSION.size(), nullptr, 10);
    std::istringstream in(text);
    std::string line;
    for (size_t i = 0; i < number && std::getline(in, line);) ++i;
    const size_t equals = line.find('=');
    const std::string key =
        equals == std::string::npos ? "" : " (" + trimmed(line.substr(0, equals)) + ")";
    return "line " + std::to_string(number) + " of '" + origin + "'" + key +
           " has an $eval{} that is no expression of numbers";
}

/** \throws ConfigurationError, naming the origin, where MRPT finds it wrong */
Content parsedByMrpt(const std::string& text, const std::string& origin)
{
    const ClassicNumbers expressions;  // of MRPT's $eval{}
    try {
        Content content;
        content.setContent(text);
        return content;
    } catch (const std::exception& e) {
        throw ConfigurationError(reasonOf(text, origin, e.what()));
    }
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/** Parses a text whose expansions of one kind stay as they are written.
 *  \param kind with what they begin: "$env{", or "$" for all of them */
Content parsedWithout(const std::string& kind, const std::string& text, const std::string& origin)
{
    static const std::string HIDDEN = "\x1A";  // in no text: see checkLines()
    Content hidden = parsedByMrpt(replaced(text, kind, HIDDEN), origin), content;
    std::vector<std::string> sections, keys;
    hidden.getAllSections(sections);
    for (const std::string& section : sections) {
        hidden.getAllKeys(section, keys);
        for (const std::string& key : keys)
            content.write(section, key,
                          replaced(hidden.read_string(section, key, ""), HIDDEN, kind));
    }
    return content;
}

/** The INI with the environment's variables named instead of expanded. */
Content asWritten(const std::string& text, const std::string& origin)
{
    try {
        return parsedWithout("$env{", text, origin);
    } catch (const ConfigurationError&) {
        return parsedWithout("$", text, origin);  // an expression needs the variable's value
    }
}

/** Whether what a variable holds is the path of something that is there, which tells nobody more.
 */
bool isKnownPath(const std::string& value)
{
    std::error_code error;
    return value[0] == '/' && std::filesystem::exists(value, error);
}

/** No message shows what MRPT puts in place of $env{NAME}. */
void hideEnvironment(const std::string& text)
{
    const std::string BEGIN = "$env{";
    for (size_t at = text.find(BEGIN); at != std::string::npos; at = text.find(BEGIN, at + 1)) {
        const size_t end = text.find('}', at);
        if (end == std::string::npos) return;
        const size_t name = at + BEGIN.size();
        const char* const value = std::getenv(text.substr(name, end - name).c_str());
        std::istringstream lines(value != nullptr ? value : "");
        for (std::string line; std::getline(lines, line);)
            if (!isKnownPath(line)) hideText(trimmed(line), text.substr(at, end + 1 - at));
    }
}

/** A text without what MRPT acts upon: lines that start with '@'. */
std::string withoutDirectives(const std::string& text)
{
    std::istringstream in(text);
    std::string data;
    for (std::string line; std::getline(in, line);)
        if (trimmed(line).compare(0, 1, "@") != 0) data += line + "\n";
    return data;
}
}  // namespace

Ini Ini::fromFile(const std::string& file)
{
    std::string text;
    try {
        text = readTextFile(file, "configuration");
    } catch (const InputError& e) {
        throw ConfigurationError(e.what());
    }
    Ini ini = fromText(text, file);
    ini.m_folder = std::filesystem::absolute(file).parent_path().string();
    return ini;
}

Ini Ini::fromText(const std::string& text, const std::string& origin)
{
    const std::string plain = plainLines(text);
    hideEnvironment(plain);
    checkLines(plain, origin);
    Ini ini;
    ini.m_origin = origin;
    ini.m_content = parsedByMrpt(plain, origin);
    ini.m_written = asWritten(plain, origin);
    return ini;
}

Ini Ini::fromMap(const std::string& text, const std::string& origin)
{
    constexpr size_t MOST_BYTES = size_t{1} << 20, MOST_LINES = 10000;  // ours have 200 lines
    if (text.size() > MOST_BYTES ||
        static_cast<size_t>(std::count(text.begin(), text.end(), '\n')) > MOST_LINES)
        throw ConfigurationError("the configuration in '" + origin +
                                 "' is longer than 1 MiB or 10000 lines, which is none of "
                                 "Voxeland's: map its rawlog again");
    const std::string plain = withoutDirectives(plainLines(text));
    checkLines(plain, origin);
    Ini ini;
    ini.m_origin = ini.m_mapName = origin;
    ini.m_content = ini.m_written = parsedWithout("$", plain, origin);
    return ini;
}

void Ini::setFromPrefixedSections(const mrpt::config::CConfigFileBase& source,
                                  const std::string& prefix, const std::vector<std::string>& names)
{
    std::vector<std::string> keys;
    for (const std::string& name : names) {
        const std::string section = prefix + "_" + name;
        if (!source.sectionExists(section)) continue;
        source.getAllKeys(section, keys);
        for (const std::string& key : keys) {
            m_content.write(name, key, source.read_string(section, key, ""));
            m_setByUser.insert(identity(name, key));
            m_unknownAsWritten.insert(identity(name, key));
        }
    }
}

std::string Ini::origin() const
{
    std::string origin = m_origin;
    for (const std::string& option : m_options) origin += (origin.empty() ? "" : ", ") + option;
    return origin.empty() ? "the defaults" : origin;
}

std::string Ini::text() const
{
    return m_content.getContent();
}

void Ini::set(const std::string& assignment, const std::string& option)
{
    if (holdsControls(assignment) || assignment.find('\n') != std::string::npos)
        throw ConfigurationError((option.empty() ? "" : option + " ") + "'" + assignment +
                                 "' holds control characters: leave them out");
    const size_t equals = assignment.find('=');
    const size_t dot = assignment.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals)
        throw ConfigurationError((option.empty() ? "" : option + " ") + "'" + assignment +
                                 "' is not of the form section.key=value");
    const std::string section = assignment.substr(0, dot),
                      key = assignment.substr(dot + 1, equals - dot - 1);
    for (Content* content : {&m_content, &m_written})
        content->write(section, key, assignment.substr(equals + 1));
    m_setByUser.insert(identity(section, key));
    m_unknownAsWritten.erase(identity(section, key));
    if (!option.empty()) m_options.push_back(option + " " + assignment.substr(0, equals));
}

std::vector<std::string> Ini::sections() const
{
    std::vector<std::string> names;
    m_content.getAllSections(names);
    return names;
}

std::vector<std::string> Ini::keys(const std::string& section) const
{
    std::vector<std::string> names;
    if (m_content.sectionExists(section)) m_content.getAllKeys(section, names);
    return names;
}

std::string Ini::value(const std::string& section, const std::string& key) const
{
    return m_content.read_string(section, key, "");
}

std::optional<std::string> Ini::written(const std::string& section, const std::string& key) const
{
    if (m_unknownAsWritten.count(identity(section, key)) > 0 || !m_written.keyExists(section, key))
        return std::nullopt;
    return m_written.read_string(section, key, "");
}

bool Ini::isOfMap(const std::string& section, const std::string& key) const
{
    return !m_mapName.empty() && m_setByUser.count(identity(section, key)) == 0;
}
}  // namespace voxeland
