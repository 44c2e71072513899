// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "voxeland/map/Decision.h"
#include "voxeland/plugins/CDisambiguator.h"
#include "voxeland/plugins/DisambiguationOptions.h"

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace voxeland
{
/** What came of a question. */
struct QuestionOutcome
{
    instance_id_t instance = UNKNOWN_INSTANCE;
    std::optional<Decision> decision;  //!< its evidence is not set yet
    std::string problem;   //!< why there is none, empty if there is, or if it was not asked
    bool failed = false;   //!< whether that was a failure of the back-end
    bool waiting = false;  //!< whether there may be an answer that can be used another time
};

/** Asks a back-end until its answer can be used, at most `max_attempts` times; once if somebody
 * answers by hand (CDisambiguator::howToAnswer()).
 *  \throws what the back-end throws */
QuestionOutcome askUntilUsable(const CDisambiguator& backend, DisambiguationQuestion question,
                               const DisambiguationOptions& options);

/** Asks questions in several threads, and gives the outcomes as they come. */
class DisambiguationRun
{
 public:
    /** Starts asking, in the order of the questions, in as many threads as the system allows.
     *  \throws InputError if it allows none */
    DisambiguationRun(std::shared_ptr<const CDisambiguator> backend,
                      std::vector<DisambiguationQuestion> questions,
                      const DisambiguationOptions& options);
    /** Asks nothing more and waits for what is being asked. */
    ~DisambiguationRun();
    DisambiguationRun(const DisambiguationRun&) = delete;
    DisambiguationRun& operator=(const DisambiguationRun&) = delete;

    /** All outcomes since the last call; empty if none comes within a fifth of a second. Those of
     * the last call count as kept: only now their threads ask the next questions, so that a run
     * that is killed loses no more than what is being asked.
     *  \return none at the end: after all were given, or after a failure that concerns all */
    std::optional<std::vector<QuestionOutcome>> next();
    /** Throws what ended the asking early, if anything did. */
    void rethrow() const;

 private:
    void start(size_t threads);
    void stop();
    /** \param fatal set to what keeps all other questions from being asked, too */
    [[nodiscard]] QuestionOutcome ask(const DisambiguationQuestion& question,
                                      std::exception_ptr& fatal) const;
    void work();

    std::shared_ptr<const CDisambiguator> m_backend;
    std::vector<DisambiguationQuestion> m_questions;
    DisambiguationOptions m_options;
    mutable std::mutex m_mutex;  //!< guards all below
    std::condition_variable m_changed;
    std::vector<QuestionOutcome> m_outcomes;
    size_t m_nextQuestion = 0, m_working = 0;
    size_t m_given = 0;              //!< outcomes that came so far
    size_t m_taken = 0, m_kept = 0;  //!< of these: returned by next(); and returned before that
    bool m_stop = false;
    std::exception_ptr m_error;
    std::vector<std::thread> m_workers;
};
}  // namespace voxeland
