// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** The category an answer names: one of the candidates, or UNKNOWN_CATEGORY_ID for "unknown".
 * Sentences "The object category is X" count, X being a whole name and nothing else; all of them
 * must name the same. Without such a sentence, exactly one name must occur in the answer, as whole
 * words, and no negation. Upper and lower case are the same. \return none if the answer names
 * several, or none */
std::optional<category_id_t> categoryNamedBy(const std::string& answer,
                                             const std::vector<RankedCategory>& candidates);
}  // namespace voxeland
