// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "common/Argument.h"

#include <mrpt/system/COutputLogger.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

// CLI11's header takes longer to compile than a whole program: CommandLine.cpp alone includes it.
namespace CLI
{
class App;
class Option;
}  // namespace CLI

namespace voxeland::apps
{
/** Characters of a note or warning; some quote a sentence and say what came of it. */
constexpr size_t LONGEST_NOTE = 600;

enum class Occurrence
{
    once,
    repeated
};

/** What every program of the project has in common on its command line: `--help` that shows
 * examples, `--version`, `-v/--verbosity` and `--quiet`. Options are given as `--name value`,
 * `--name=value` or `-n value`; a value may be empty or begin with '-'; behind `--`
 * nothing is an option. A program declares its own as members of a class derived from this. */
class CommandLine
{
 public:
    enum class Rest
    {
        refused,
        command
    };

    /** \param description what the program does, and examples; printed as it is by --help
     *  \param rest what words are that belong to no option: refused, or a command to run, which
     *  begins with the first of them */
    explicit CommandLine(std::string description, Rest rest = Rest::refused);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /** \return false if --help or --version was asked for and printed: end with exit code 0
     *  \throws ConfigurationError for wrong usage */
    [[nodiscard]] bool parse(int argc, const char* const* argv);
    /** The command that was given, for a shell, with other values of some options, or with these
     * added. \param values by the options' long names, like "--from" */
    [[nodiscard]] std::string commandWith(const std::map<std::string, std::string>& values) const;
    /** How many words at the end are the command to run, see Rest. */
    [[nodiscard]] size_t wordsOfCommand() const { return m_wordsOfCommand; }
    /** Least severe message to show. */
    [[nodiscard]] mrpt::system::VerbosityLevel verbosity() const;
    /** Whether progress and notes are not wanted. */
    [[nodiscard]] bool quiet() const { return verbosity() > mrpt::system::LVL_INFO; }
    /** Says something on stderr, unless quiet(). */
    void note(const std::string& text) const;
    /** Says on stderr what is probably not as the user meant it, unless errors alone are wanted. */
    void warn(const std::string& text) const;

 private:
    friend class Switch;
    friend class SwitchOrText;
    friend class Text;
    friend class Texts;
    template <typename N>
    friend class Number;

    /** Gives an argument what was given for it. */
    static std::function<bool(const std::vector<std::string>&)> takerOf(Argument& argument);
    void addSwitch(Argument& argument, const std::string& names, const std::string& description);
    void addSwitchOrOption(Argument& argument, const std::string& names, const std::string& value,
                           const std::string& description);
    void addOption(Argument& argument, const std::string& names, const std::string& value,
                   const std::string& description, Presence presence, Occurrence occurrence);
    [[nodiscard]] std::vector<std::string> valuesApart(const std::vector<std::string>& words) const;

    std::unique_ptr<CLI::App> m_app;
    std::string m_description;
    std::string m_program;             //!< as it was called
    std::vector<std::string> m_words;  //!< its words, values apart from names
    size_t m_wordsOfCommand = 0;
    Switch m_quiet;
    Text m_verbosity;
};
}  // namespace voxeland::apps
