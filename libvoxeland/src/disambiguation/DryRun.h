// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <string>
#include <vector>

namespace voxeland
{
/** What questions would take. */
struct Estimate
{
    size_t questions = 0, pictures = 0;
    uint64_t tokens = 0;  //!< of the questions, see estimatedTokens()
    double cost = 0;      //!< in the INI's currency; 0 if it names no prices
};
Estimate estimate(const std::vector<DisambiguationQuestion>& questions,
                  const DisambiguationOptions& options);

/** Writes what would be asked: `questions.json` with everything but the pictures, and for each
 * question a folder `instance-ID` with `prompt.txt` and its pictures, `picture-01.jpg` and so on.
 *  \param folder made if missing
 *  \throws OutputError that names the questions whose folders are complete */
void writeQuestions(const std::vector<DisambiguationQuestion>& questions,
                    const DisambiguationOptions& options, const std::string& folder);
}  // namespace voxeland
