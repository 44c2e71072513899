// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "UncertainInstance.h"
#include "voxeland/plugins/CDisambiguator.h"

#include <string>

namespace voxeland
{
/** The words of a question, made from a template in which stand `{candidates}` (a line each, with
 * its probability), `{names}` (all in one line) and `{pictures}` (a line each: what it shows). */
class Prompt
{
 public:
    /** \param file of the template; empty: the built-in one, share/prompts/disambiguate.txt
     *  \throws ConfigurationError if it cannot be read, or does not ask for one of `{names}` */
    explicit Prompt(const std::string& file = "");

    /** \param question its candidates and pictures */
    [[nodiscard]] std::string words(const DisambiguationQuestion& question) const;

 private:
    std::string m_template;
};

/** What is added to a question whose answer could not be used.
 *  \param attempt number of the time it is asked, from 2; part of the words, since recorded and
 * cached answers belong to the words of a question */
std::string askedAgain(const DisambiguationQuestion& question, uint32_t attempt);
}  // namespace voxeland
