// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/plugins/Ini.h"

#include "voxeland/ClassicNumbers.h"
#include "voxeland/errors.h"
#include "voxeland/trimmed.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

namespace voxeland
{
namespace
{
std::string firstLine(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

/** A text without the byte order mark before it, with '\n' at the end of each line. */
std::string plainLines(std::string text)
{
    constexpr std::string_view MARK = "\xEF\xBB\xBF";
    if (text.compare(0, MARK.size(), MARK) == 0) text.erase(0, MARK.size());
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
            plain += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            plain += '\n';
    return plain;
}

/** MRPT's parser passes over what it does not understand; this does not. */
void checkLines(const std::string& text, const std::string& origin)
{
    std::istringstream in(text);
    bool continued = false;
    size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string words = trimmed(line);
        const bool follows = std::exchange(continued, !words.empty() && words.back() == '\\');
        if (words.empty() || follows) continue;
        const bool special = std::string("#;[@").find(words[0]) != std::string::npos;
        if (special || words.compare(0, 2, "//") == 0) continue;
        if (line.find('=') == std::string::npos)
            throw ConfigurationError("line " + std::to_string(number) + " of '" + origin +
                                     "' is neither '[section]' nor 'key = value'");
    }
}
}  // namespace

Ini Ini::fromFile(const std::string& file)
{
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw ConfigurationError("cannot read the configuration '" + file +
                                 "': give the path of an INI file");
    std::ostringstream text;
    text << in.rdbuf();
    Ini ini = fromText(text.str(), file);
    ini.m_folder = std::filesystem::absolute(file).parent_path().string();
    return ini;
}

Ini Ini::fromText(const std::string& text, const std::string& origin)
{
    const std::string plain = plainLines(text);
    checkLines(plain, origin);
    Ini ini;
    ini.m_origin = origin;
    const ClassicNumbers expressions;  // of MRPT's $eval{}
    try {
        ini.m_content.setContent(plain);
    } catch (const std::exception& e) {
        throw ConfigurationError("'" + origin + "' is not a valid INI: " + firstLine(e.what()));
    }
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
        for (const std::string& key : keys)
            m_content.write(name, key, source.read_string(section, key, ""));
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
    const size_t equals = assignment.find('=');
    const size_t dot = assignment.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals)
        throw ConfigurationError((option.empty() ? "" : option + " ") + "'" + assignment +
                                 "' is not of the form section.key=value");
    m_content.write(assignment.substr(0, dot), assignment.substr(dot + 1, equals - dot - 1),
                    assignment.substr(equals + 1));
    if (!option.empty()) m_options.push_back(option + " " + assignment);
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
}  // namespace voxeland
