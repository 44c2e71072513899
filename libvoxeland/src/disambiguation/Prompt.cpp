// SPDX-License-Identifier: BSD-3-Clause
#include "Prompt.h"

#include "BuiltInPrompt.h"
#include "base/ClassicNumbers.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"

#include <mrpt/core/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace voxeland
{
namespace
{
std::string readTemplate(const std::string& file)
{
    std::ifstream in;
    if (std::filesystem::is_regular_file(file)) in.open(file);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || text.str().empty())
        throw ConfigurationError("[disambiguation] prompt = '" + file +
                                 "' cannot be read: name a file with the template");
    if (text.str().find("{names}") == std::string::npos)
        throw ConfigurationError("[disambiguation] prompt = '" + file +
                                 "' does not hold {names}: say which answers are possible");
    return text.str();
}

std::string namesOf(const DisambiguationQuestion& question)
{
    std::string names;
    for (const RankedCategory& c : question.candidates)
        names += (names.empty() ? "" : ", ") + printable(c.name);
    return names;
}

std::string withoutLastBreak(std::string text)
{
    if (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}
}  // namespace

Prompt::Prompt(const std::string& file)
    : m_template(file.empty() ? BUILT_IN_PROMPT : readTemplate(file))
{
}

std::string Prompt::words(const DisambiguationQuestion& question) const
{
    std::string candidates, pictures;
    for (const RankedCategory& c : question.candidates)
        candidates += format("- %s: %.2f\n", printable(c.name).c_str(), c.probability);
    for (size_t i = 0; i < question.pictures.size(); ++i)
        pictures += format("%zu. %s\n", i + 1, question.pictures[i].caption.c_str());

    const std::pair<std::string, std::string> values[] = {
        {"{candidates}", withoutLastBreak(candidates)},
        {"{pictures}", withoutLastBreak(pictures)},
        {"{names}", namesOf(question)}};
    std::string words;
    for (size_t at = 0; at < m_template.size();) {
        bool replaced = false;
        for (const auto& [key, value] : values)
            if (!replaced && m_template.compare(at, key.size(), key) == 0) {
                words += value;
                at += key.size();
                replaced = true;
            }
        if (!replaced) words += m_template[at++];
    }
    return words;
}

std::string askedAgain(const DisambiguationQuestion& question, uint32_t attempt)
{
    return "\nAttempt " + std::to_string(attempt) +
           ": your last answer could not be used. Answer with one line only: \"The object category "
           "is <category>\", <category> being exactly one of: " +
           namesOf(question) + ", unknown.\n";
}
}  // namespace voxeland
