// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/3rdparty/tclap/CmdLine.h>
#include <mrpt/system/COutputLogger.h>

#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace voxeland::apps
{
/** Characters of a note or warning; some quote a sentence and say what came of it. */
constexpr size_t LONGEST_NOTE = 600;

/** What every program of the project has in common on its command line: `--help` that shows
 * examples,
 *  `--version`, `-v/--verbosity` and `--quiet`. Add the program's own arguments to parser(). */
class CommandLine
{
 public:
    /** \param description what the program does, and examples; printed as it is by --help */
    explicit CommandLine(const std::string& description);

    [[nodiscard]] TCLAP::CmdLine& parser() { return m_parser; }
    /** \return false if --help or --version was asked for and printed: end with exit code 0
     *  \throws ConfigurationError for wrong usage */
    [[nodiscard]] bool parse(int argc, char** argv);
    /** The command that was given, for a shell, with other values of some options, or with these
     * added. \param values by the options' long names, like "--from" */
    [[nodiscard]] std::string commandWith(const std::map<std::string, std::string>& values) const;
    /** Least severe message to show. */
    [[nodiscard]] mrpt::system::VerbosityLevel verbosity() const;
    /** Whether progress and notes are not wanted. */
    [[nodiscard]] bool quiet() const { return verbosity() > mrpt::system::LVL_INFO; }
    /** Says something on stderr, unless quiet(). */
    void note(const std::string& text) const;
    /** Says on stderr what is probably not as the user meant it, unless errors alone are wanted. */
    void warn(const std::string& text);

 private:
    TCLAP::CmdLine m_parser;
    TCLAP::ValueArg<std::string> m_verbosity;
    TCLAP::SwitchArg m_quiet;
    std::vector<std::string> m_words;  //!< as given, `--name=value` in two
};

/** What an exception says, in one line: MRPT wraps its messages in a title and the call stack. */
std::string sentence(const std::exception& e);

/** Makes sure before the work that no output would replace an input or another output, and that all
 * outputs may be written. Empty names are passed over.
 *  \throws ConfigurationError, or OutputError as checkWritable(), naming the file */
void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/** Runs a program's body; an exception becomes one sentence on stderr and its exit code (see
 *  voxeland/errors.h; 3 for anything else that MRPT or a library threw while reading).
 *  \return exit code of the program */
int runProgram(const char* program, const std::function<int()>& body);
}  // namespace voxeland::apps
