// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/CategoryEvidence.h"

#include <mrpt/core/Clock.h>

#include <cstdint>
#include <string>

namespace voxeland
{
/** What a disambiguation back-end decided about an instance: one more opinion, kept apart from what
 * detectors said so that it can be taken back without a trace. */
struct Decision
{
    category_id_t category = UNKNOWN_CATEGORY_ID;  //!< or UNKNOWN_CATEGORY_ID: none of those asked
    double evidence = 0;                           //!< beta it adds to that category, > 0
    std::string source;                            //!< class of the back-end
    std::string model;                             //!< who answered
    std::string answer;                            //!< in the back-end's own words
    mrpt::Clock::time_point time;                  //!< of the answer
    double seconds = 0;                            //!< from question to answer
    uint64_t promptTokens = 0, answerTokens = 0;   //!< of all attempts; 0: unknown
    double cost = 0;         //!< of those tokens, in the INI's currency; 0: unknown
    uint32_t questions = 1;  //!< how often it was asked until the answer could be used
};
}  // namespace voxeland
