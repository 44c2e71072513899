// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/MapQueries.h"
#include "voxeland/plugins/Plugin.h"

#include <string>
#include <vector>

namespace voxeland
{
/** What a back-end is asked about one uncertain instance. */
struct DisambiguationQuestion
{
    instance_id_t instance = UNKNOWN_INSTANCE;
    std::vector<RankedCategory> candidates;  //!< the categories to choose from, the likeliest first
    std::string prompt;                      //!< the whole question in words
    std::vector<std::string> images;  //!< encoded pictures (JPEG or PNG), in the prompt's order
};

/** What a back-end answered. */
struct DisambiguationAnswer
{
    std::string category;  //!< one of the candidates' names, or UNKNOWN_CATEGORY
    std::string text;      //!< the answer as it was given
};

inline namespace abi_1
{
/** Base of the plugins that decide an uncertain instance's category (paper, "Uncertainty
 * Exploitation Through Semantic Disambiguation"). Chosen in section [disambiguation] of the INI. */
class CDisambiguator : public Plugin
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CDisambiguator)

 public:
    /** Asks one question and waits for the answer.
     *  \throws std::runtime_error if there is none */
    [[nodiscard]] virtual DisambiguationAnswer ask(
        const DisambiguationQuestion& question) const = 0;
};
}  // namespace abi_1
}  // namespace voxeland
