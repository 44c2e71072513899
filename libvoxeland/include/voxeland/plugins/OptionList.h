// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace voxeland
{
class Ini;

/** The options of one INI section: each with its key, the variable it sets (whose value beforehand
 * is the default), unit and explanation. The one place where keys are listed, read, checked and
 * printed. Holds references to the variables. */
class OptionList
{
 public:
    /** Closed range of allowed values. */
    struct Range
    {
        double least = -std::numeric_limits<double>::infinity();
        double most = std::numeric_limits<double>::infinity();
    };

    void add(const std::string& key, std::string& variable, const std::string& comment);
    void add(const std::string& key, bool& variable, const std::string& comment);
    void add(const std::string& key, int& variable, const Range& range, const std::string& comment);
    void add(const std::string& key, uint32_t& variable, const Range& range,
             const std::string& comment);
    void add(const std::string& key, double& variable, const Range& range,
             const std::string& comment);

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

    /** A key of earlier versions: an INI that has it, or a map made with one, is read as before,
     *  but the key does nothing any more. */
    void retire(const std::string& key) { m_retired.push_back(key); }

    /** Sets the variables that `section` of the INI names, and adds a sentence to `problems` for
     * every value that is malformed or out of range, and for every unknown key (with the nearest
     * known one). */
    void load(const Ini& ini, const std::string& section, std::vector<std::string>& problems) const;

    /** Prints the section with all keys, current values and comments, as an INI that can be read
     * back. */
    void print(std::ostream& out, const std::string& section) const;

 private:
    using Printer = std::function<std::string()>;
    /** Sets the variable; returns what is wrong with the text, empty if nothing. */
    using Parser = std::function<std::string(const std::string&)>;

    struct Option
    {
        std::string key, comment;
        Printer print;
        Parser parse;
    };

    void addText(const std::string& key, Printer print, Parser parse, const std::string& comment);
    template <typename Number>
    void addNumber(const std::string& key, Number& variable, const Range& range,
                   const std::string& comment);

    std::vector<Option> m_options;
    std::vector<std::string> m_retired;
};

/** Of some words the one most like a misspelt one; empty if none is near. */
std::string nearestWord(const std::string& misspelt, const std::vector<std::string>& words);
}  // namespace voxeland
