// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

namespace voxeland
{
/** The baseline: answers with the likeliest candidate, without looking at anything. */
class CTopCategoryDisambiguator : public CDisambiguator
{
    DEFINE_MRPT_OBJECT(CTopCategoryDisambiguator, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList&) override {}
    /** "unknown" where there is no candidate. */
    [[nodiscard]] std::optional<DisambiguationAnswer> ask(
        const DisambiguationQuestion& question) const override;
};
}  // namespace voxeland
