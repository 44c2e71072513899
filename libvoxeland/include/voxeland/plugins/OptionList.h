// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voxeland
{
class Ini;

/** The options of one INI section: each with its key, the variable it sets (whose value beforehand
 * is the default), unit and explanation. The one place where keys are listed, read, checked and
 * printed. Holds references to the variables.
 *
 *  It is also the one place that decides what the configuration stored in a map may say: numbers,
 * words of a list, and no text (which may name a file, a server, a library) unless it is declared
 * harmless. What a map says beyond that is left alone, see leftToUser(). */
class OptionList
{
 public:
    /** Tells the values of an option that a map may choose; any user may choose any. */
    using OfMaps = bool (*)(const std::string& value);
    static bool anyValue(const std::string&) { return true; }
    static bool noValue(const std::string&) { return false; }

    /** Closed range of allowed values. */
    struct Range
    {
        double least = -std::numeric_limits<double>::infinity();
        double most = std::numeric_limits<double>::infinity();
    };

    /** \param ofMaps noValue for what is a file, a server, a command or the like; anyValue for
     *  mere names */
    void add(const std::string& key, std::string& variable, const std::string& comment,
             OfMaps ofMaps = noValue);
    /** \param ofMaps noValue for what protects the user */
    void add(const std::string& key, bool& variable, const std::string& comment,
             OfMaps ofMaps = anyValue);
    void add(const std::string& key, int& variable, const Range& range, const std::string& comment);
    void add(const std::string& key, uint32_t& variable, const Range& range,
             const std::string& comment);
    void add(const std::string& key, double& variable, const Range& range,
             const std::string& comment);

    /** Where a server is, http[s]://host[:port]/path. Name and password for it in front of the host
     *  are refused, and hidden. */
    void addUrl(const std::string& key, std::string& variable, const std::string& comment);
    /** The name of an environment variable, such as that of a key. Who takes it for the variable's
     *  value writes the key there: it is hidden, in print() too, unless a variable is called so. */
    void addVariableName(const std::string& key, std::string& variable, const std::string& comment);

    /** An option given by one of a few words. \param words each with the value it stands for */
    template <typename Enum>
    void add(const std::string& key, Enum& variable,
             const std::vector<std::pair<std::string, Enum>>& words, const std::string& comment)
    {
        std::string allowed;
        for (const auto& [word, value] : words) allowed += (allowed.empty() ? "" : " | ") + word;
        addText(
            key,
            [&variable, words] {
                for (const auto& [word, value] : words)
                    if (value == variable) return word;
                return std::string();
            },
            [&variable, words, allowed](const std::string& text) {
                for (const auto& [word, value] : words)
                    if (word == text) {
                        variable = value;
                        return std::string();
                    }
                return "is not one of " + allowed;
            },
            comment + ": " + allowed);
    }

    /** A part of the method, which can be left out. */
    struct Part
    {
        std::string name;
        bool& isUsed;
        std::string formerKey = {};  //!< that switched it in earlier versions; empty: none
    };
    /** The key `ablation`: which of these parts are left out, to see what they are worth. */
    void addAblation(const std::vector<Part>& parts);

    /** What is added from here on is seldom changed, or as often as the rest. */
    void forExperts(bool seldom = true) { m_forExperts = seldom; }

    /** The option added last concerns a run and not the map that it makes: maps hold its default.
     */
    void concernsRun() { m_options.back().isOfRun = true; }

    /** A key of earlier versions: an INI that has it, or a map made with one, is read as before,
     *  but the key does nothing any more. */
    void retire(const std::string& key);

    /** Sets the variables that `section` of the INI names, and adds a sentence to `problems` for
     * every value that is malformed or out of range, and for every unknown key (with the nearest
     * known one). */
    void load(const Ini& ini, const std::string& section, std::vector<std::string>& problems);

    /** What a map said and load() left alone, as `[section] key = 'value'`: it is the user's to
     *  say. Without what is the default anyway. */
    [[nodiscard]] const std::vector<std::string>& leftToUser() const { return m_leftToUser; }

    enum class Keys
    {
        common,  //!< and those for experts that do not have their default
        all,
        ofMap  //!< all, those that concern a run with their default
    };
    /** Prints the section with keys, current values and comments, as an INI that can be read back.
     * Texts are printed as they were written, with the environment's variables by name; those
     * of which that is not known, only as far as a map may say them. */
    void print(std::ostream& out, const std::string& section, Keys keys = Keys::all) const;

 private:
    using Printer = std::function<std::string()>;
    /** Sets the variable; returns what is wrong with the text, empty if nothing. */
    using Parser = std::function<std::string(const std::string&)>;

    struct Option
    {
        std::string key, comment;
        Printer print;
        Parser parse;
        OfMaps ofMaps;
        bool isText;
        bool isForExperts;
        std::string preset;                                 //!< what it prints by default
        bool isFormer = false;                              //!< read, but not printed
        std::optional<std::string> printed = std::nullopt;  //!< instead of the value
        bool isOfRun = false;
        /** How a value begins that nobody may see: "" of one that everybody may. */
        std::function<std::string(const std::string&)> secret = [](const std::string&) {
            return std::string();
        };
    };

    void addText(const std::string& key, Printer print, Parser parse, const std::string& comment);
    /** What to print instead of a text's value, if anything. */
    static std::optional<std::string> printedFor(const Option& option, const Ini& ini,
                                                 const std::string& section);
    template <typename Number>
    void addNumber(const std::string& key, Number& variable, const Range& range,
                   const std::string& comment);

    std::vector<Option> m_options;
    std::vector<std::string> m_leftToUser;
    bool m_forExperts = false;
};
}  // namespace voxeland
