// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "Prompt.h"
#include "UncertainInstance.h"
#include "voxeland/plugins/CDisambiguator.h"

#include <vector>

namespace voxeland
{
/** The question about an instance whose pictures were fetched: photographs of each candidate's
 * views, then the whole frame and the reconstructed voxels if the options say so.
 *  \param up the map's, see estimateUp() */
DisambiguationQuestion questionAbout(const UncertainInstance& instance, const SemanticVoxelMap& map,
                                     const mrpt::math::TVector3D& up, const Prompt& prompt,
                                     const DisambiguationOptions& options);

/** Tokens that a question takes, as OpenAI's models count: a word is a little more than one, a
 * picture as many as tiles of 512 pixels cover it. Others count otherwise. */
uint64_t estimatedTokens(const DisambiguationQuestion& question);

/** Tokens of an answer that is as it should be. */
inline constexpr uint64_t ANSWER_TOKENS = 12;

/** What tokens cost, in the INI's currency. */
double costOf(uint64_t promptTokens, uint64_t answerTokens, const DisambiguationOptions& options);
}  // namespace voxeland
