// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/config/CConfigFileMemory.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace voxeland
{
/** An INI that was read and parsed, with MRPT's syntax (variables, expressions, `\` line ends);
 * unlike MRPT it never is silent about a file that is missing. What `$env{NAME}` was in a user's
 * is hidden, see hideText().
 *
 *  What stands in a map is data, from whoever made the map: nothing in it is expanded, and it is
 * known which values are the map's (see isOfMap()) so that OptionList takes only harmless ones. */
class Ini
{
 public:
    /** Empty: all defaults. */
    Ini() = default;
    /** \throws ConfigurationError, naming the file, if it is missing or not an INI */
    static Ini fromFile(const std::string& file);
    /** \param origin what to call it in messages \throws ConfigurationError if it is not an INI */
    static Ini fromText(const std::string& text, const std::string& origin);
    /** The configuration stored in a map. \param origin what to call the map in messages
     *  \throws ConfigurationError if it is not an INI, or longer than 1 MiB or 10000 lines */
    static Ini fromMap(const std::string& text, const std::string& origin);
    /** Takes over the sections called `<prefix>_<name>` of another program's INI.
     *  \param names the names to look for. What the user wrote there, before MRPT expanded it, is
     *  not known: see written() */
    void setFromPrefixedSections(const mrpt::config::CConfigFileBase& source,
                                 const std::string& prefix, const std::vector<std::string>& names);

    /** Applies `section.key=value`, as given on a command line.
     *  \param option by which it was given, for messages; empty: by none
     *  \throws ConfigurationError if the text has another form */
    void set(const std::string& assignment, const std::string& option = "");

    /** What to call this INI in messages: its file, and the keys that options of a
     *  command line set. */
    [[nodiscard]] std::string origin() const;
    /** Folder of the file, absolute; empty if it did not come from one. */
    [[nodiscard]] const std::string& folder() const { return m_folder; }
    /** Everything as text. */
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::vector<std::string> sections() const;
    [[nodiscard]] std::vector<std::string> keys(const std::string& section) const;
    /** Value of a key that is there. */
    [[nodiscard]] std::string value(const std::string& section, const std::string& key) const;
    /** The same with `$env{NAME}` as it was written: the environment of a user must not get into
     * files. None if that is not known. */
    [[nodiscard]] std::optional<std::string> written(const std::string& section,
                                                     const std::string& key) const;
    /** Whether a value comes from a map, and not from the user. */
    [[nodiscard]] bool isOfMap(const std::string& section, const std::string& key) const;
    /** What to call the map that isOfMap() values come from. */
    [[nodiscard]] const std::string& mapName() const { return m_mapName; }

 private:
    using Content = mrpt::config::CConfigFileMemory;

    Content m_content, m_written;
    std::string m_origin, m_folder;      //!< empty: all defaults, no file
    std::string m_mapName;               //!< empty: all is the user's
    std::vector<std::string> m_options;  //!< with the keys they set
    /** Section and key, in small letters, of what the user set ... */
    std::set<std::pair<std::string, std::string>> m_setByUser;
    /** ... and of that what may have been expanded before. */
    std::set<std::pair<std::string, std::string>> m_unknownAsWritten;
};
}  // namespace voxeland
