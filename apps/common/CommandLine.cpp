// SPDX-License-Identifier: BSD-3-Clause
#include "common/CommandLine.h"

#include "common/AsTyped.h"
#include "common/say.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/joined.h"
#include "voxeland/base/nearestWord.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

using mrpt::system::VerbosityLevel;

namespace voxeland::apps
{
namespace
{
constexpr const char* LEVELS = "DEBUG, INFO, WARN, ERROR";
constexpr auto ONCE = CLI::MultiOptionPolicy::Throw, REPEATED = CLI::MultiOptionPolicy::TakeAll;

ConfigurationError wrongUsage(const std::string& what)
{
    return ConfigurationError(what + " (see --help)");
}

/** Whether a word is an option's, unless it is a value or behind `--`. */
bool isName(const std::string& word)
{
    return word.size() > 1 && word[0] == '-' && word != "--";
}

/** The name in `--name=value`; short ones are followed by nothing. */
std::string nameIn(const std::string& word)
{
    constexpr size_t SHORTEST = 3;  // "--n"
    return word.compare(0, 2, "--") == 0 ? word.substr(0, word.find('=', SHORTEST)) : word;
}

bool takesValue(const CLI::Option& option)
{
    return option.get_items_expected_max() > 0;
}

bool needsValue(const CLI::Option& option)
{
    return option.get_items_expected_min() > 0;
}

/** The ways to give an option, as "-i <FILE>" and "--input <FILE>". */
std::vector<std::string> usesOf(const CLI::Option& option)
{
    std::string value = takesValue(option) ? "<" + option.get_type_name() + ">" : "";
    if (takesValue(option) && !needsValue(option)) value = "[" + option.get_type_name() + "]";
    if (option.get_positional()) return {value};
    std::vector<std::string> uses;
    const std::string suffix = value.empty() ? "" : " " + value;
    for (const std::string& name : option.get_snames()) uses.push_back("-" + name + suffix);
    for (const std::string& name : option.get_lnames()) uses.push_back("--" + name + suffix);
    return uses;
}

/** The options that must be given and are not. */
std::string missing(const CLI::App& app)
{
    std::vector<std::string> uses;
    for (const CLI::Option* o : app.get_options())
        if (o->get_required() && o->empty()) uses.push_back(usesOf(*o).front());
    return joined(uses, " and ");
}

/** The name among these that was probably meant, one it begins or resembles; empty if none is. */
std::string probablyMeant(const std::string& given, const std::vector<std::string>& names)
{
    constexpr size_t LEAST = 3;  // letters that resemble another word by more than chance
    if (given.size() < LEAST) return {};
    for (const std::string& name : names)
        if (name.compare(0, given.size(), given) == 0) return name;
    return nearestWord(given, names);
}

/** What to say of a word that is no option, and no value of one. */
std::string unknown(const CLI::App& app, const std::string& word)
{
    const size_t begin = std::min(word.find_first_not_of('-'), word.size());
    const std::string option = nameIn(word);
    if (!isName(word) || app.get_option_no_throw(option) != nullptr)
        return "'" + word + "' belongs to no option";
    std::vector<std::string> names;
    for (const CLI::Option* o : app.get_options())
        for (const std::string& name : o->get_lnames()) names.push_back(name);
    const std::string bare = option.substr(begin);
    const std::string meant = probablyMeant(bare.substr(0, bare.find('=')), names);
    return "there is no option " + option +
           (meant.empty() ? "" : ", did you mean --" + meant + "?");
}

/** A paragraph in lines of at most 96 characters, indented. */
std::string filled(const std::string& text)
{
    constexpr size_t WIDTH = 96;
    const std::string INDENT(6, ' ');
    std::string lines, line;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ' ');) {
        if (!line.empty() && line.size() + 1 + word.size() > WIDTH) {
            lines += line + "\n";
            line.clear();
        }
        line += (line.empty() ? INDENT : " ") + word;
    }
    return lines + line + "\n";
}

std::string helpOn(const CLI::Option& option)
{
    const bool isRepeated = takesValue(option) && option.get_multi_option_policy() == REPEATED;
    return "  " + joined(usesOf(option), ",  ") +
           (isRepeated ? "  (accepted multiple times)\n" : "\n") +
           filled((option.get_required() ? "(required)  " : "") + option.get_description());
}

std::string helpOn(const CLI::App& app)
{
    std::string withPlace, named;
    for (const CLI::Option* o : app.get_options())
        (o->get_positional() ? withPlace : named) += helpOn(*o);
    return withPlace + named;
}

/** Its options are shown in the order they are added in. */
std::unique_ptr<CLI::App> appWithHelp()
{
    auto app = std::make_unique<CLI::App>();
    app->set_help_flag("-h,--help", "Displays usage information and exits.");
    app->set_version_flag("--version", VOXELAND_VERSION, "Displays version information and exits.");
    return app;
}

/** The words that belong to no option: those of a command to run, if one is wanted. */
std::vector<std::string> leftOver(const CLI::App& app)
{
    std::vector<std::string> words = app.remaining();
    if (!words.empty() && words.front() == "--") words.erase(words.begin());
    return words;
}

std::optional<std::string> strayWord(const CLI::App& app)
{
    const auto words = leftOver(app);
    const bool isCommand = app.get_prefix_command() && !words.empty() &&
                           (!isName(words.front()) || app.remaining().front() == "--");
    return words.empty() || isCommand ? std::nullopt : std::optional(words.front());
}

/** What is wrong with a command line that CLI11 refuses. */
std::string problem(const CLI::App& app, const CLI::ParseError& e,
                    const std::vector<std::string>& words)
{
    if (const auto stray = strayWord(app)) return unknown(app, *stray);
    for (const CLI::Option* o : app.get_options())
        if (o->get_multi_option_policy() == ONCE && o->count() > 1)
            return o->get_name() + " is given twice";
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&e) != nullptr)
        return words.back() + " needs a value";
    return "give " + missing(app);
}
}  // namespace

CommandLine::CommandLine(std::string description, Rest rest)
    : m_app(appWithHelp()),
      m_description(std::move(description)),
      m_quiet(*this, "--quiet", "No progress and no messages but warnings and errors: as -v WARN"),
      m_verbosity(
          *this, "-v,--verbosity", "LEVEL",
          "Least severe messages to show: INFO (notes and progress), WARN or ERROR; DEBUG is "
          "for MRPT's programs in voxeland-run",
          "INFO")
{
    m_app->prefix_command(rest == Rest::command);
}

CommandLine::~CommandLine() = default;

std::function<bool(const std::vector<std::string>&)> CommandLine::takerOf(Argument& argument)
{
    return [&argument](const std::vector<std::string>& values) {
        argument.take(values);
        argument.m_isSet = true;
        return true;
    };
}

void CommandLine::addSwitch(Argument& argument, const std::string& names,
                            const std::string& description)
{
    m_app
        ->add_flag_callback(
            names, [&argument] { argument.m_isSet = true; }, description)
        ->multi_option_policy(ONCE);
}

void CommandLine::addSwitchOrOption(Argument& argument, const std::string& names,
                                    const std::string& value, const std::string& description)
{
    m_app->add_option(names, takerOf(argument), description)
        ->type_name(value)
        ->expected(0, 1)
        ->multi_option_policy(ONCE);
}

void CommandLine::addOption(Argument& argument, const std::string& names, const std::string& value,
                            const std::string& description, Presence presence,
                            Occurrence occurrence)
{
    m_app->add_option(names, takerOf(argument), description)
        ->type_name(value)
        ->required(presence == Presence::required)
        ->multi_option_policy(occurrence == Occurrence::once ? ONCE : REPEATED);
}

/** Puts values apart from names: CLI11 would take `--name=` for a name whose value follows,
 * `-ofile` for `-o file` and `--switch=no` for the switch. */
std::vector<std::string> CommandLine::valuesApart(const std::vector<std::string>& words) const
{
    std::vector<std::string> apart;
    for (size_t i = 0; i < words.size(); ++i) {
        const std::string &word = words[i], name = nameIn(word);
        if (word == "--" || (m_app->get_prefix_command() && !isName(word))) {
            apart.insert(apart.end(), words.begin() + static_cast<long>(i), words.end());
            break;
        }
        const CLI::Option* option = isName(word) ? m_app->get_option_no_throw(name) : nullptr;
        if (option == nullptr) {
            const bool isRunTogether = isName(word) && word[1] != '-' && word.size() > 2;
            if (isRunTogether) throw wrongUsage(unknown(*m_app, word));
            apart.push_back(word);
            continue;
        }
        apart.push_back(name);
        if (name != word && !takesValue(*option)) throw wrongUsage(name + " takes no value");
        if (name != word)
            apart.push_back(word.substr(name.size() + 1));
        else if (i + 1 < words.size() &&
                 (needsValue(*option) || (takesValue(*option) && !isName(words[i + 1]))))
            apart.push_back(words[++i]);
    }
    return apart;
}

bool CommandLine::parse(int argc, const char* const* argv)
{
    m_program = argv[0];
    m_words = valuesApart({argv + 1, argv + argc});
    try {
        m_app->parse(std::vector<std::string>(m_words.rbegin(), m_words.rend()));
    } catch (const CLI::CallForHelp&) {
        std::cout << m_description << "\n\nOptions:\n" << helpOn(*m_app);
        return false;
    } catch (const CLI::CallForVersion&) {
        std::cout << m_program << " " << VOXELAND_VERSION << "\n";
        return false;
    } catch (const CLI::ParseError& e) {
        throw wrongUsage(problem(*m_app, e, m_words));
    }
    if (const auto stray = strayWord(*m_app)) throw wrongUsage(unknown(*m_app, *stray));
    m_wordsOfCommand = leftOver(*m_app).size();
    static_cast<void>(verbosity());  // complain about it now
    return true;
}

std::string CommandLine::commandWith(const std::map<std::string, std::string>& values) const
{
    std::vector<std::string> command = {m_program};
    for (size_t i = 0; i < m_words.size(); ++i)
        if (values.count(m_words[i]) > 0)
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
    std::string name = m_verbosity.value();
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

void CommandLine::warn(const std::string& text) const
{
    if (verbosity() > mrpt::system::LVL_WARN) return;
    say(std::filesystem::path(m_program).filename().string() + ": warning: " + text, LONGEST_NOTE);
}
}  // namespace voxeland::apps
