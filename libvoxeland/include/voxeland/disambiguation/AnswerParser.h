// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voxeland
{
/** Of an answer that is longer without its thoughts the last part counts [bytes]. */
constexpr size_t LONGEST_ANSWER = 8192;

/** The category an answer names: one of the candidates, or UNKNOWN_CATEGORY_ID for "unknown" or
 * "none of these". It is understood as a person would, and never guessed.
 *
 * Names are whole words in any case, in the singular or plural, with blanks, - or _ or nothing
 * between their words. Thoughts before the answer, marks of a model's template, Markdown, JSON and
 * LaTeX are no matter. The first of these that the answer holds decides:
 *
 * 1. statements "the (object) category is NAME", "answer: NAME", `\boxed{NAME}`,
 *    `<answer>NAME</answer>` and the like; those from the first "final answer" on alone, if any;
 * 2. sentences or lines that are "NAME" or "it is NAME";
 * 3. all words, if names that are denied ("not a NAME") or only a place ("on a NAME") are left out.
 *
 * What decides must name the same throughout, surely ("maybe", "could be" are not enough), and with
 * nothing joined to it ("NAME or NAME", "NAME leg"). Adjectives and articles may precede a name,
 * and a reason follow it. \return none if several are named, or none, or something else */
std::optional<category_id_t> categoryNamedBy(const std::string& answer,
                                             const std::vector<RankedCategory>& candidates);
}  // namespace voxeland
