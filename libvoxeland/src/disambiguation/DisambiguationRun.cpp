// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/DisambiguationRun.h"

#include "Prompt.h"
#include "Questions.h"
#include "voxeland/base/errors.h"
#include "voxeland/disambiguation/AnswerParser.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace voxeland
{
QuestionOutcome askUntilUsable(const CDisambiguator& backend, DisambiguationQuestion question,
                               const DisambiguationOptions& options)
{
    QuestionOutcome outcome;
    outcome.instance = question.instance;
    const std::string firstPrompt = question.prompt;
    Decision decision;
    decision.source = backend.GetRuntimeClass()->className;
    outcome.waiting = !backend.howToAnswer().empty();
    const uint32_t attempts = outcome.waiting ? 1 : options.max_attempts;
    for (uint32_t attempt = 1; attempt <= attempts; ++attempt) {
        const auto answer = backend.ask(question);
        if (!answer) {
            outcome.problem = "there is no answer yet";
            outcome.waiting = true;
            return outcome;
        }
        decision.model = answer->model;
        decision.answer = answer->text;
        decision.questions = attempt;
        decision.seconds += answer->seconds;
        decision.promptTokens += answer->promptTokens;
        decision.answerTokens += answer->answerTokens;
        if (const auto category = categoryNamedBy(answer->text, question.candidates)) {
            decision.category = *category;
            decision.time = mrpt::Clock::now();
            decision.cost = costOf(decision.promptTokens, decision.answerTokens, options);
            outcome.decision = decision;
            outcome.waiting = false;
            return outcome;
        }
        question.prompt = firstPrompt + askedAgain(question, attempt + 1);
    }
    outcome.problem = "no answer names exactly one candidate, the last was: " + decision.answer;
    return outcome;
}

DisambiguationRun::DisambiguationRun(std::shared_ptr<const CDisambiguator> backend,
                                     std::vector<DisambiguationQuestion> questions,
                                     const DisambiguationOptions& options)
    : m_backend(std::move(backend)), m_questions(std::move(questions)), m_options(options)
{
    try {
        start(std::min<size_t>(options.parallel, m_questions.size()));
    } catch (...) {
        stop();
        throw;
    }
}

void DisambiguationRun::start(size_t threads)
{
    m_workers.reserve(threads);
    const std::lock_guard<std::mutex> lock(m_mutex);  // they begin when all are counted
    try {
        for (; m_working < threads; ++m_working) m_workers.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        if (m_working == 0) throw InputError("no thread can be started to ask: free some memory");
    }
}

DisambiguationRun::~DisambiguationRun()
{
    stop();
}

void DisambiguationRun::stop()
{
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_all();
    for (std::thread& worker : m_workers) worker.join();
}

QuestionOutcome DisambiguationRun::ask(const DisambiguationQuestion& question,
                                       std::exception_ptr& fatal) const
{
    QuestionOutcome outcome;
    outcome.instance = question.instance;
    try {
        return askUntilUsable(*m_backend, question, m_options);
    } catch (const DisambiguationError& e) {
        outcome.problem = e.what();
        if (e.fatal) fatal = std::current_exception();
    } catch (const std::exception& e) {
        outcome.problem = e.what();
        fatal = std::current_exception();
    }
    outcome.failed = true;
    return outcome;
}

void DisambiguationRun::work()
{
    for (;;) {
        size_t number = 0;
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            if (m_stop || m_nextQuestion == m_questions.size()) {
                --m_working;
                m_changed.notify_all();
                return;
            }
            number = m_nextQuestion++;
        }
        std::exception_ptr fatal;
        std::unique_lock<std::mutex> lock(m_mutex, std::defer_lock);
        try {
            QuestionOutcome outcome = ask(m_questions[number], fatal);
            lock.lock();
            m_outcomes.push_back(std::move(outcome));
        } catch (...) {  // no memory for the outcome
            fatal = std::current_exception();
            if (!lock.owns_lock()) lock.lock();
        }
        const size_t mine = ++m_given;
        if (fatal) {
            m_stop = true;
            if (!m_error) m_error = fatal;
        }
        m_changed.notify_all();
        m_changed.wait(lock, [&] { return m_kept >= mine || m_stop; });
    }
}

std::optional<std::vector<QuestionOutcome>> DisambiguationRun::next()
{
    std::unique_lock<std::mutex> lock(m_mutex);
    m_kept = m_taken;
    m_changed.notify_all();
    m_changed.wait_for(lock, std::chrono::milliseconds(200),
                       [this] { return !m_outcomes.empty() || m_working == 0; });
    if (m_outcomes.empty() && m_working == 0) return std::nullopt;
    m_taken += m_outcomes.size();
    return std::exchange(m_outcomes, {});
}

void DisambiguationRun::rethrow() const
{
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_error) std::rethrow_exception(m_error);
}
}  // namespace voxeland
