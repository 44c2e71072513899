// SPDX-License-Identifier: BSD-3-Clause
/** Asks a back-end about the objects of a map whose category is uncertain. */
#include "common/AsTyped.h"
#include "common/CommandLine.h"
#include "common/Interruption.h"
#include "common/Progress.h"
#include "common/SetArgument.h"
#include "common/TrustPathsArgument.h"
#include "common/checkOutputs.h"
#include "common/runProgram.h"
#include "disambiguation/AnswerJournal.h"
#include "disambiguation/Checkpoint.h"
#include "disambiguation/Decisions.h"
#include "disambiguation/DisambiguationReport.h"
#include "disambiguation/DryRun.h"
#include "disambiguation/Questions.h"
#include "disambiguation/Revision.h"
#include "disambiguation/ViewChoice.h"
#include "disambiguation/ViewPictures.h"
#include "files/OutputPart.h"
#include "plugins/PluginLoader.h"
#include "voxeland/base/counted.h"
#include "voxeland/base/errors.h"
#include "voxeland/base/printable.h"
#include "voxeland/disambiguation/DisambiguationRun.h"
#include "voxeland/files/AtomicFile.h"
#include "voxeland/level/UpDirection.h"
#include "voxeland/metric_map/CVoxelandMap.h"
#include "voxeland/metric_map/MapFile.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>

using namespace voxeland;

namespace
{
const char* const DESCRIPTION =
    R"(Asks about the objects of a map whose category is uncertain, with pictures of their best views.

  voxeland-disambiguate -m kitchen.voxeland -i kitchen.rawlog -c my.ini --dry-run questions
  voxeland-disambiguate -m kitchen.voxeland -i kitchen.rawlog -c my.ini -o decided.voxeland
  voxeland-disambiguate -m decided.voxeland -o before.voxeland --undo all

Who is asked, and about what, is said in section [disambiguation] of the INI: a model behind the chat
completions protocol, a person, recorded answers, or by default nobody (the likeliest category stays).
share/config/disambiguate-*.ini are examples. The rawlog is the one the map was made from.

The output is written at the end; until then answers are kept beside it, in OUT.voxeland.answers. Run
the same command again to go on where a run stopped, was interrupted or killed.
Exit codes: 0 done, 1 usage or configuration, 2 back-end, 3 input, 5 output, 130 interrupted.)";

/** The program's command line. */
struct Arguments : apps::CommandLine
{
    Arguments() : CommandLine(DESCRIPTION) {}

    apps::Text undo{*this, "--undo", "ID|all",
                    "Take the decisions about an instance, or all of them, back"};
    apps::Text report{*this, "--report", "F.json", "Write what was asked and what came of it"};
    apps::Text dryRun{*this, "--dry-run", "DIR",
                      "Write what would be asked into this folder, and ask nothing"};
    apps::TrustPathsArgument trustPaths{*this};
    apps::SetArgument set{*this, "configuration"};
    apps::Text output{*this, "-o,--output", "MAP.voxeland", "Map to write"};
    apps::Text config{*this, "-c,--config", "FILE.ini",
                      "Configuration (default: the one stored in the map)"};
    apps::Text input{*this, "-i,--input", "FILE.rawlog",
                     "Rawlog or simplemap the map was made from"};
    apps::Text map{*this, "-m,--map", "MAP.voxeland", "Map to read", apps::Presence::required};
};

Ini configuration(Arguments& arguments, const CVoxelandMap& map)
{
    Ini ini = arguments.config.isSet() ? Ini::fromFile(arguments.config.value())
                                       : Ini::fromMap(map.configText(), arguments.map.value());
    arguments.set.applyTo(ini);
    return ini;
}

void checkArguments(Arguments& arguments)
{
    const bool asks = !arguments.undo.isSet();
    if (asks && !arguments.input.isSet())
        throw ConfigurationError("give the rawlog the map was made from with -i (see --help)");
    if (arguments.output.value().empty() && !arguments.dryRun.isSet())
        throw ConfigurationError("give a map to write with -o, or --dry-run (see --help)");
    apps::checkOutputs(
        {{arguments.output.value(), arguments.report.value()}, {}, {arguments.dryRun.value()}},
        {{arguments.map.value(), arguments.config.value()}, {arguments.input.value()}, {}});
}

int undo(Arguments& arguments, CVoxelandMap& map)
{
    const std::string& what = arguments.undo.value();
    std::optional<instance_id_t> instance;
    if (what != "all") {
        instance_id_t id = UNKNOWN_INSTANCE;
        const auto [end, error] = std::from_chars(what.data(), what.data() + what.size(), id);
        if (error != std::errc() || end != what.data() + what.size() ||
            map.map().resolve(id) == UNKNOWN_INSTANCE)
            throw ConfigurationError("--undo: there is no instance '" + what +
                                     "': name one of voxeland-info --instances, or all");
        instance = id;
    }
    const size_t undone = undoDecisions(map.editMap(), instance);
    saveMap(map, arguments.output.value());
    std::cout << "decisions taken back: " << undone << "\n";
    return 0;
}

/** The questions to ask about a map, with their pictures. */
std::vector<DisambiguationQuestion> makeQuestions(Arguments& arguments, const SemanticVoxelMap& map,
                                                  const MapperConfig& config)
{
    const Prompt prompt(config.disambiguation.prompt);
    auto uncertain = uncertainInstances(map, config.disambiguation);
    size_t missing = 0;
    {
        apps::Progress progress("% of the rawlog", 100, !arguments.quiet());
        missing = fetchPictures(uncertain, arguments.input.value(), config, [&](double share) {
            progress.update(static_cast<size_t>(100 * share), share);
        });
    }
    if (missing > 0)
        arguments.warn("the rawlog lacks the frames of " + counted(missing, "view") +
                       "; was the map made from several?");
    const auto up = estimateUp(map);
    std::vector<DisambiguationQuestion> questions;
    for (UncertainInstance& u : uncertain) {
        keepChosenViews(u, config.disambiguation);
        if (!u.views.empty())
            questions.push_back(questionAbout(u, map, up, prompt, config.disambiguation));
    }
    return questions;
}

void sayEstimate(const Estimate& e)
{
    std::cout << counted(e.questions, "question") << " with " << counted(e.pictures, "picture")
              << ", about " << counted(e.tokens, "token");
    if (e.cost > 0) std::cout << ", cost about " << e.cost;
    std::cout << "\n";
}

void sayTooSmall(const SemanticVoxelMap& map, const DisambiguationOptions& options)
{
    if (const size_t n = countTooSmallToAsk(map, options); n > 0)
        std::cout << "not asked about " << counted(n, "uncertain object") << " of fewer than "
                  << counted(options.min_voxels, "voxel") << " ([disambiguation] min_voxels)\n";
}

/** What somebody has to do before the same command goes on. */
void sayWaiting(const DisambiguationReport& report, const std::string& howToAnswer,
                const std::vector<std::string>& command)
{
    size_t waiting = 0;
    for (const ReportedQuestion& q : report.questions()) waiting += q.outcome.waiting ? 1 : 0;
    if (waiting == 0 || howToAnswer.empty()) return;
    std::cout << counted(waiting, "question")
              << " without an answer: " << printable(howToAnswer, UNCUT) << ", then go on with\n  "
              << apps::asTyped(command) << "\n";
}

/** Writes the map with all answers so far. */
void save(Arguments& arguments, const CVoxelandMap& map, AnswerJournal& journal)
{
    saveMap(map, arguments.output.value());
    journal.discard();
}

/** What there is of a run that fails after its map was saved. */
void sayKept(const Arguments& arguments)
{
    std::cout << "what was answered so far is in " << printable(arguments.output.value(), UNCUT)
              << ": run the same command again to go on\n";
}

/** Ends the program without waiting for what is being asked. */
[[noreturn]] void endInterrupted(size_t answered)
{
    std::cout.flush();
    std::cerr << "\nvoxeland-disambiguate: interrupted; keeping " << counted(answered, "answer")
              << ": run the same command again to go on\n";
    removeUnfinishedParts();  // of threads that write what they were answered
    std::_Exit(apps::INTERRUPTED);
}

/** Asks all questions and saves the map. \return what came of them */
DisambiguationReport askAll(Arguments& arguments, CVoxelandMap& map, const MapperConfig& config,
                            const Revision& revision, AnswerJournal& journal,
                            std::vector<DisambiguationQuestion> questions)
{
    DisambiguationReport report;
    for (const DisambiguationQuestion& q : questions) report.before(map.map(), q.instance);
    apps::Progress progress("questions", questions.size(), !arguments.quiet());
    size_t done = 0;
    const apps::Interruption interruption;
    DisambiguationRun asking(config.disambiguator, std::move(questions), config.disambiguation);
    while (auto outcomes = asking.next()) {
        for (QuestionOutcome& o : *outcomes) {
            if (o.decision) {
                revision.decide(map.editMap(), o.instance, *o.decision, config.disambiguation);
                journal.add(o.instance, map.map().instance(o.instance).decisions.back());
            }
            report.after(map.map(), std::move(o));
            ++done;
        }
        progress.update(done);
        if (interruption.wasRequested()) {
            save(arguments, map, journal);
            endInterrupted(done);
        }
    }
    save(arguments, map, journal);
    if (arguments.report.isSet())
        writeAtomically(arguments.report.value(),
                        [&](std::ostream& out) { out << report.asJson(map.map()); });
    try {
        asking.rethrow();
    } catch (...) {
        std::cout << report.asText();
        sayKept(arguments);
        throw;
    }
    return report;
}

/** The questions to ask about a map; also those that a back-end that keeps its answers decided in
 * earlier runs, in the same words. */
std::vector<DisambiguationQuestion> makeQuestions(Arguments& arguments, const SemanticVoxelMap& map,
                                                  const Revision& revision, MapperConfig config)
{
    if (!config.disambiguator->keepsAnswers()) return makeQuestions(arguments, map, config);
    SemanticVoxelMap asked = map;
    const auto again = static_cast<uint32_t>(revision.withdraw(asked));
    if (config.disambiguation.max_questions > 0) config.disambiguation.max_questions += again;
    return makeQuestions(arguments, asked, config);
}

/** Takes over what earlier runs were answered. */
void goOn(Arguments& arguments, CVoxelandMap& map, const MapperConfig& config,
          const Revision& revision, AnswerJournal& journal)
{
    const std::string& output = arguments.output.value();
    const size_t decisions = takeOverDecisions(map, output);
    const size_t answers = journal.replay(map.map(), [&](instance_id_t id, const Decision& d) {
        revision.decide(map.editMap(), id, d, config.disambiguation);
    });
    if (decisions > 0)
        arguments.note("going on with " + counted(decisions, "decision") + " in '" + output + "'");
    if (answers > 0)
        arguments.note("going on with " + counted(answers, "answer") +
                       " of a run that did not come to its end");
}

int ask(Arguments& arguments, CVoxelandMap& map, const std::vector<std::string>& command)
{
    MapperConfig config(configuration(arguments, map), MapperConfig::Purpose::asking,
                        [&](const std::string& left) { arguments.warn(left); });
    config.input = map.withCamera(config.input);
    config.input.trust_paths = arguments.trustPaths.isSet();
    const bool dry = arguments.dryRun.isSet();
    if (!dry) config.disambiguator->start();
    const Revision revision(map.map(), config.disambiguator->GetRuntimeClass()->className);
    std::optional<AnswerJournal> journal;
    if (!dry) {
        journal.emplace(arguments.output.value(), arguments.map.value(),
                        config.disambiguator->GetRuntimeClass()->className);
        if (!config.disambiguation.ask_again) goOn(arguments, map, config, revision, *journal);
    }
    auto questions = makeQuestions(arguments, map.map(), revision, config);
    if (dry) {
        writeQuestions(questions, config.disambiguation, arguments.dryRun.value());
        sayEstimate(estimate(questions, config.disambiguation));
        sayTooSmall(map.map(), config.disambiguation);
        return 0;
    }
    const DisambiguationReport report =
        askAll(arguments, map, config, revision, *journal, std::move(questions));
    std::cout << report.asText();
    sayTooSmall(map.map(), config.disambiguation);
    sayWaiting(report, config.disambiguator->howToAnswer(), command);
    for (const ReportedQuestion& q : report.questions()) {
        if (!q.outcome.failed) continue;
        sayKept(arguments);
        throw DisambiguationError("some questions have no answer: " + q.outcome.problem, false);
    }
    return 0;
}

int run(int argc, char** argv)
{
    Arguments arguments;
    if (!arguments.parse(argc, argv)) return 0;
    checkArguments(arguments);
    const auto map = loadMap(arguments.map.value());
    return arguments.undo.isSet() ? undo(arguments, *map)
                                  : ask(arguments, *map, {argv, argv + argc});
}
}  // namespace

int main(int argc, char** argv)
{
    return apps::runProgram("voxeland-disambiguate", [&] { return run(argc, argv); });
}
