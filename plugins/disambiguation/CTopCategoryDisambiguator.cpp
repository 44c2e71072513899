// SPDX-License-Identifier: BSD-3-Clause
#include "CTopCategoryDisambiguator.h"

#include "voxeland/base/RegisteredClass.h"

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CTopCategoryDisambiguator, voxeland::CDisambiguator, voxeland)

std::string CTopCategoryDisambiguator::description() const
{
    return "keeps the likeliest category: the baseline";
}

std::optional<DisambiguationAnswer> CTopCategoryDisambiguator::ask(
    const DisambiguationQuestion& question) const
{
    DisambiguationAnswer answer;
    answer.text = "The object category is " +
                  (question.candidates.empty() ? "unknown" : question.candidates.front().name) +
                  ".";
    answer.model = "the likeliest category";
    return answer;
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CTopCategoryDisambiguator> REGISTERED;
