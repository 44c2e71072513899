// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/plugins/CDisambiguator.h"

#include <memory>

namespace voxeland
{
/** Answers from a folder, without a network. A question that has no answer there is put to another
 * back-end and its answer recorded, or, if there is no other, written out for a person to answer.
 * The files are described at QuestionFolder. */
class CReplayDisambiguator : public CDisambiguator
{
    DEFINE_MRPT_OBJECT(CReplayDisambiguator, voxeland)

 public:
    [[nodiscard]] std::string description() const override;
    void declareOptions(OptionList& options) override;
    /** \throws ConfigurationError, PluginError or OutputError */
    void start() override;
    /** \throws OutputError if a question or an answer cannot be written */
    [[nodiscard]] std::optional<DisambiguationAnswer> ask(
        const DisambiguationQuestion& question) const override;
    [[nodiscard]] bool keepsAnswers() const override { return true; }
    /** That of the back-end it records, if any. */
    [[nodiscard]] std::string howToAnswer() const override;

 private:
    std::string m_folder = "questions", m_recordConfig;
    std::shared_ptr<const CDisambiguator> m_recorded;
};
}  // namespace voxeland
