// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/base/errors.h"
#include "voxeland/map/MapQueries.h"
#include "voxeland/plugins/Plugin.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** A picture shown with a question. */
struct DisambiguationPicture
{
    std::string caption;    //!< what it shows, in a few words
    std::string mediaType;  //!< image/jpeg or image/png
    std::string bytes;      //!< the encoded file
};

/** What a back-end is asked about one uncertain instance. */
struct DisambiguationQuestion
{
    instance_id_t instance = UNKNOWN_INSTANCE;
    std::vector<RankedCategory> candidates;       //!< to choose from, the likeliest first
    std::string prompt;                           //!< the whole question in words
    std::vector<DisambiguationPicture> pictures;  //!< in the order the prompt mentions them
};

/** What a back-end answered, in its own words, and what that took. */
struct DisambiguationAnswer
{
    std::string text;   //!< the answer as it was given; which category it names is read elsewhere
    std::string model;  //!< who answered: a model's name, "a person", ...
    uint64_t promptTokens = 0, answerTokens = 0;  //!< as the server counted them; 0: unknown
    double seconds = 0;                           //!< from question to answer
};

inline namespace VOXELAND_PLUGIN_ABI
{
/** Base of the plugins that decide an uncertain instance's category (paper, "Uncertainty
 * Exploitation Through Semantic Disambiguation"). Chosen in section [disambiguation] of the INI. */
class CDisambiguator : public Plugin
{
    VOXELAND_DEFINE_VIRTUAL_MRPT_OBJECT(CDisambiguator)

 public:
    /** Asks one question and waits for the answer. Called from several threads at once.
     *  \return none if there is no answer yet, and there may be one another time (a person has not
     *  written it)
     *  \throws DisambiguationError if the back-end cannot be asked; `fatal` if no other question
     *  can be either */
    [[nodiscard]] virtual std::optional<DisambiguationAnswer> ask(
        const DisambiguationQuestion& question) const = 0;

    /** Whether answers stay where they were given, so that the same question costs nothing and its
     * answer may have changed: what was decided by it in earlier runs is then asked again. */
    [[nodiscard]] virtual bool keepsAnswers() const { return false; }
    /** What somebody has to do about questions without an answer yet, as a clause such as "write it
     * into ..."; empty if nobody has to. Such questions are not put in other words. */
    [[nodiscard]] virtual std::string howToAnswer() const { return {}; }
};
}  // namespace VOXELAND_PLUGIN_ABI
}  // namespace voxeland
