// SPDX-License-Identifier: BSD-3-Clause
#include "CReplayDisambiguator.h"

#include "QuestionFolder.h"
#include "voxeland/io/OutputFolder.h"
#include "voxeland/plugins/Ini.h"
#include "voxeland/plugins/PluginLoader.h"

#include <mrpt/core/initializer.h>

namespace voxeland
{
IMPLEMENTS_MRPT_OBJECT(CReplayDisambiguator, voxeland::CDisambiguator, voxeland)

namespace
{
/** The back-end that an INI's section [disambiguation] describes. */
std::shared_ptr<const CDisambiguator> backendOf(const std::string& iniFile)
{
    constexpr auto SECTION = "disambiguation";
    const Ini ini = Ini::fromFile(iniFile);
    std::string library, className;
    std::vector<std::string> problems;
    OptionList options;
    options.add("plugin", library, "");
    options.add("class", className, "");
    options.load(ini, SECTION, problems);
    problems.clear();  // which other keys there are is known once there is an object
    if (!library.empty()) loadPlugin(library, pluginSearchPath(ini.folder()));
    auto backend = createPlugin<CDisambiguator>(className);
    backend->declareOptions(options);
    options.load(ini, SECTION, problems);
    std::string all;
    for (const std::string& problem : problems) all += (all.empty() ? "" : "; ") + problem;
    if (!all.empty()) throw ConfigurationError("configuration of '" + iniFile + "': " + all);
    backend->start();
    return backend;
}
}  // namespace

std::string CReplayDisambiguator::description() const
{
    return "recorded answers, or a person's: questions are written to a folder to be answered";
}

void CReplayDisambiguator::declareOptions(OptionList& options)
{
    options.add("folder", m_folder,
                "Where questions and answers are, a folder each; created if absent");
    options.add("record_config", m_recordConfig,
                "INI whose [disambiguation] names another back-end (plugin, class and its keys) to "
                "answer, once, what has no answer; empty: a person does");
}

void CReplayDisambiguator::start()
{
    if (m_folder.empty())
        throw ConfigurationError("[disambiguation] folder is empty: name a folder");
    makeOutputFolder(m_folder);
    if (!m_recordConfig.empty()) m_recorded = backendOf(m_recordConfig);
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
}  // namespace voxeland

MRPT_INITIALIZER(registerReplayDisambiguator)
{
    mrpt::rtti::registerClass(CLASS_ID(voxeland::CReplayDisambiguator));
}
