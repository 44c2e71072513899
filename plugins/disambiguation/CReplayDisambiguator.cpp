// SPDX-License-Identifier: BSD-3-Clause
#include "CReplayDisambiguator.h"

#include "QuestionFolder.h"
#include "voxeland/base/RegisteredClass.h"
#include "voxeland/files/OutputFolder.h"
#include "voxeland/pipeline/MapperConfig.h"

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CReplayDisambiguator, voxeland::CDisambiguator, voxeland)

std::string CReplayDisambiguator::description() const
{
    return "recorded answers, or a person's: questions are written to a folder to be answered";
}

void CReplayDisambiguator::declareOptions(OptionList& options)
{
    options.add("folder", m_folder,
                "Where questions and answers are, a folder each; created if absent");
    options.add("record_config", m_recordConfig,
                "INI whose [disambiguation] names another back-end to answer, once, what has no "
                "answer; empty: a person does");
}

void CReplayDisambiguator::start()
{
    if (m_folder.empty())
        throw ConfigurationError("[disambiguation] folder is empty: name a folder");
    makeOutputFolder(m_folder);
    if (m_recordConfig.empty()) return;
    const auto recorded =
        MapperConfig(Ini::fromFile(m_recordConfig), MapperConfig::Purpose::asking).disambiguator;
    recorded->start();
    m_recorded = recorded;
}

std::optional<DisambiguationAnswer> CReplayDisambiguator::ask(
    const DisambiguationQuestion& question) const
{
    const QuestionFolder folder(m_folder, question);
    if (auto known = folder.answer()) return known;
    folder.writeQuestion(question);
    const auto answer = m_recorded ? m_recorded->ask(question) : std::nullopt;
    if (answer)
        folder.writeAnswer(*answer);
    else
        folder.writeForm(question);
    return answer;
}

std::string CReplayDisambiguator::howToAnswer() const
{
    if (m_recorded) return m_recorded->howToAnswer();
    return "look at the pictures in each folder of '" +
           std::filesystem::absolute(m_folder).lexically_normal().string() +
           "' and write into its answer.txt what the object is";
}
}  // namespace voxeland

const voxeland::RegisteredClass<voxeland::CReplayDisambiguator> REGISTERED;
