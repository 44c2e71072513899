// SPDX-License-Identifier: BSD-3-Clause
#include "common/CommandLine.h"

#include "common/AsTyped.h"
#include "common/Interruption.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/printable.h"
#include "voxeland/files/AtomicFile.h"

#include <mrpt/core/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <list>
#include <new>
#include <set>
#include <stdexcept>
#include <unistd.h>

using mrpt::system::VerbosityLevel;

namespace fs = std::filesystem;

namespace voxeland::apps
{
namespace
{
constexpr const char* LEVELS = "DEBUG, INFO, WARN, ERROR";

/** The arguments that must be given and are not. */
std::string missing(TCLAP::CmdLineInterface& c)
{
    std::vector<std::string> names;
    auto arguments = c.getArgList();
    arguments.reverse();
    for (const TCLAP::Arg* a : arguments)
        if (a->isRequired() && !a->isSet()) names.push_back(a->shortID());
    return joined(names, " and ");
}

/** What is wrong with a command line, with the option's name. */
std::string problem(TCLAP::CmdLineInterface& c, const TCLAP::ArgException& e)
{
    static const std::string TITLE = "Argument: ";
    std::string option = e.argId();
    const std::string error = e.error();
    if (option.compare(0, TITLE.size(), TITLE) == 0) option.erase(0, TITLE.size());
    const auto isBracket = [](char c) { return c == '(' || c == ')'; };
    option.erase(std::remove_if(option.begin(), option.end(), isBracket), option.end());
    const auto begins = [&](const char* with) { return error.rfind(with, 0) == 0; };
    if (begins("One or more required") || begins("Required argument")) return "give " + missing(c);
    if (begins("Missing a value")) return option + " needs a value";
    if (begins("Couldn't find match")) return "there is no option " + option;
    if (begins("Argument already set")) return option + " is given twice";
    if (begins("Couldn't read argument value")) {
        const size_t quote = error.find(" '");
        return option + " takes a number, not" +
               (quote == std::string::npos ? " such text" : error.substr(quote));
    }
    return option + ": " + error;
}

/** Prints the description untouched (TCLAP would refill its lines) and wrong usage in one sentence.
 */
class HelpOutput : public TCLAP::StdOutput
{
 public:
    void usage(TCLAP::CmdLineInterface& c) override
    {
        std::cout << c.getMessage() << "\n\nOptions:\n";
        auto arguments = c.getArgList();
        arguments.reverse();
        for (const TCLAP::Arg* a : arguments) {
            if (a->longID() == "--ignore_rest" || a->getName() == "ignore_rest") continue;
            std::cout << "  " << a->longID() << "\n";
            spacePrint(std::cout, a->getDescription(), 96, 6, 0);
        }
    }
    void version(TCLAP::CmdLineInterface& c) override
    {
        std::cout << c.getProgramName() << " " << c.getVersion() << "\n";
    }
    void failure(TCLAP::CmdLineInterface& c, TCLAP::ArgException& e) override
    {
        throw ConfigurationError(problem(c, e) + " (see --help)");
    }
};

HelpOutput helpOutput;

/** The words of a command line, with `--name=value` as the `--name value` that TCLAP takes;
 * what follows `--` is left as it is. */
std::vector<std::string> wordsOf(int argc, char** argv, const std::list<TCLAP::Arg*>& options)
{
    std::vector<std::string> words;
    bool verbatim = false;
    for (int i = 0; i < argc; ++i) {
        const std::string word = argv[i], name = word.substr(0, word.find('='));
        verbatim = verbatim || word == "--";
        const bool hasValue =
            !verbatim && name != word &&
            std::any_of(options.begin(), options.end(), [&](const TCLAP::Arg* option) {
                return option->isValueRequired() && "--" + option->getName() == name;
            });
        words.push_back(hasValue ? name : word);
        if (hasValue) words.push_back(word.substr(name.size() + 1));
    }
    return words;
}

bool isCount(const TCLAP::Arg* option)
{
    return dynamic_cast<const TCLAP::ValueArg<uint32_t>*>(option) != nullptr ||
           dynamic_cast<const TCLAP::ValueArg<uint64_t>*>(option) != nullptr;
}

/** TCLAP reads -1 as a large number where a number without a sign is wanted. */
void refuseNegativeCounts(const std::vector<std::string>& words,
                          const std::list<TCLAP::Arg*>& options)
{
    for (size_t i = 1; i < words.size(); ++i)
        for (const TCLAP::Arg* option : options)
            if (isCount(option) && "--" + option->getName() == words[i - 1] && words[i][0] == '-')
                throw ConfigurationError(words[i - 1] + " takes a number from 0, not " + words[i]);
}

/** The one way to stderr. */
void say(const std::string& text, size_t maxLength)
{
    std::cerr << printableSentence(text, maxLength) << "\n";
}

int fail(const std::string& program, const std::string& text, int exitCode)
{
    constexpr size_t LONGEST = 299;
    say(program + ": " + text, LONGEST);
    return exitCode;
}

constexpr auto OUT_OF_MEMORY = "out of memory: use a coarser resolution or a smaller input";
constexpr int UNREADABLE = 3;  // exit code

/** In a function that must not throw, in our code or another library's, the lack of memory ends the
 * program. Says so, without memory. */
[[noreturn]] void endWithoutMemory()
{
    if (!RefusedMemory::isNoted()) std::abort();
    const char* const PARTS[] = {program_invocation_short_name, ": ", OUT_OF_MEMORY, "\n"};
    for (const char* text : PARTS)
        static_cast<void>(!write(STDERR_FILENO, text, std::strlen(text)));
    _exit(UNREADABLE);
}

int runWatched(const char* program, const std::function<int()>& body)
{
    try {
        const int exitCode = body();
        RefusedMemory::check();
        if (!std::cout.flush())
            throw OutputError("cannot write to standard output: free some space");
        return exitCode;
    } catch (const Interrupted& e) {
        fail(program, e.what(), INTERRUPTED);
        if (!e.command.empty()) std::cerr << e.command << "\n";
        return INTERRUPTED;
    } catch (...) {
        // Whatever the lack of memory was taken for.
        RefusedMemory::check();
        throw;
    }
}

/** A message without the place in MRPT's sources that begins its own: "file.cpp:57: [function] ".
 */
std::string withoutPlace(const std::string& text)
{
    const size_t function = text.find(": ["), end = text.find("] ");
    if (function == std::string::npos || end == std::string::npos || end < function) return text;
    const fs::path place = text.substr(0, text.rfind(':', function - 1));
    const bool isSource = place.extension() == ".cpp" || place.extension() == ".h";
    return isSource && place.string().find(' ') == std::string::npos ? text.substr(end + 2) : text;
}

/** Whether a message is one of a library for programmers: nobody has said what it means. */
bool isJargon(const std::exception& e, const std::string& message)
{
    const auto begins = [&](const std::string& start) {
        return message.compare(0, start.size(), start) == 0;
    };
    return begins("OpenCV(") || begins("[json.exception") ||
           message.find(' ') == std::string::npos ||
           dynamic_cast<const std::length_error*>(&e) != nullptr ||
           dynamic_cast<const std::out_of_range*>(&e) != nullptr;
}
}  // namespace

CommandLine::CommandLine(const std::string& description)
    : m_parser(description, ' ', VOXELAND_VERSION),
      m_verbosity("v", "verbosity",
                  "Least severe messages to show: INFO (notes and progress), WARN or ERROR; DEBUG "
                  "is for MRPT's programs in voxeland-run",
                  false, "INFO", "LEVEL"),
      m_quiet("", "quiet", "No progress and no messages but warnings and errors: as -v WARN")
{
    m_parser.setOutput(&helpOutput);
    m_parser.add(m_quiet);
    m_parser.add(m_verbosity);
}

bool CommandLine::parse(int argc, char** argv)
{
    std::vector<const char*> words;
    m_words = wordsOf(argc, argv, m_parser.getArgList());
    refuseNegativeCounts(m_words, m_parser.getArgList());
    for (const std::string& text : m_words) words.push_back(text.c_str());
    if (!m_parser.parse(static_cast<int>(words.size()), words.data())) return false;
    static_cast<void>(verbosity());  // complain about it now
    return true;
}

std::string CommandLine::commandWith(const std::map<std::string, std::string>& values) const
{
    std::vector<std::string> command;
    for (size_t i = 0; i < m_words.size(); ++i)
        if (i > 0 && values.count(m_words[i]) > 0)
            ++i;  // its value, too
        else
            command.push_back(m_words[i]);
    for (const auto& [option, value] : values) {
        command.push_back(option);
        command.push_back(value);
    }
    return asTyped(command);
}

VerbosityLevel CommandLine::verbosity() const
{
    if (m_quiet.isSet()) return mrpt::system::LVL_WARN;
    std::string name = const_cast<TCLAP::ValueArg<std::string>&>(m_verbosity).getValue();
    std::transform(name.begin(), name.end(), name.begin(), ::toupper);
    for (const auto& [level, text] :
         {std::pair(mrpt::system::LVL_DEBUG, "DEBUG"), std::pair(mrpt::system::LVL_INFO, "INFO"),
          std::pair(mrpt::system::LVL_WARN, "WARN"), std::pair(mrpt::system::LVL_ERROR, "ERROR")})
        if (name == text) return level;
    throw ConfigurationError("verbosity '" + name + "' is not one of " + LEVELS);
}

void CommandLine::note(const std::string& text) const
{
    if (!quiet()) say(text, LONGEST_NOTE);
}

void CommandLine::warn(const std::string& text)
{
    if (verbosity() > mrpt::system::LVL_WARN) return;
    const std::filesystem::path program = m_parser.getProgramName();
    say(program.filename().string() + ": warning: " + text, LONGEST_NOTE);
}

std::string sentence(const std::exception& e)
{
    if (const auto* files = dynamic_cast<const fs::filesystem_error*>(&e))
        return "cannot use '" + files->path1().string() + "': " + files->code().message() +
               ": correct the path or its permissions";
    const auto* mrpts = dynamic_cast<const mrpt::ExceptionWithCallBackBase*>(&e);
    const std::string text = mrpts != nullptr ? mrpts->originalWhat : e.what();
    const std::string line = withoutPlace(text.substr(0, text.find('\n')));
    return isJargon(e, line) ? "an input is damaged or not of the kind that is expected (" + line +
                                   "): leave out one after the other to find it"
                             : line;
}

void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs)
{
    const auto place = [](const std::string& file) {
        return fs::weakly_canonical(fs::absolute(file));
    };
    std::set<fs::path> taken;
    for (const std::string& input : inputs)
        if (!input.empty()) taken.insert(place(input));
    for (const std::string& output : outputs)
        if (!output.empty() && !fs::is_character_file(output) &&
            !taken.insert(place(output)).second)
            throw ConfigurationError(
                "output '" + output +
                "' would replace an input or another output: name another file");
    for (const std::string& output : outputs)
        if (!output.empty()) checkWritable(output);
}

int runProgram(const char* program, const std::function<int()>& body)
{
    RefusedMemory::watch();
    std::set_terminate(&endWithoutMemory);
    try {
        return runWatched(program, body);
    } catch (const ConfigurationError& e) {
        return fail(program, sentence(e), 1);
    } catch (const PluginError& e) {
        return fail(program, sentence(e), 2);
    } catch (const NothingToMapError& e) {
        return fail(program, sentence(e), 4);
    } catch (const OutputError& e) {
        return fail(program, sentence(e), 5);
    } catch (const std::bad_alloc&) {
        return fail(program, OUT_OF_MEMORY, UNREADABLE);
    } catch (const std::exception& e) {
        return fail(program, sentence(e), UNREADABLE);
    }
}
}  // namespace voxeland::apps
