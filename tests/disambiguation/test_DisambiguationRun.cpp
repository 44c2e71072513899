// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/base/errors.h"
#include "voxeland/disambiguation/DisambiguationRun.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <mutex>
#include <set>

using namespace voxeland;

namespace voxeland::test
{
/** Says what it was told to, by instance, one answer after the other; the last one for ever. An
 * empty answer is none, "fail" and "fatal" are failures. */
class CScripted : public CDisambiguator
{
    DEFINE_MRPT_OBJECT(CScripted, voxeland::test)

 public:
    std::map<instance_id_t, std::vector<std::string>> script;
    mutable std::map<instance_id_t, std::vector<std::string>> prompts;
    std::string byHand;  //!< see howToAnswer()

    [[nodiscard]] std::string description() const override { return "a script"; }
    void declareOptions(OptionList&) override {}
    [[nodiscard]] std::optional<DisambiguationAnswer> ask(
        const DisambiguationQuestion& question) const override
    {
        std::string text;
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            auto& asked = prompts[question.instance];
            const auto& answers = script.at(question.instance);
            text = answers.at(std::min(asked.size(), answers.size() - 1));
            asked.push_back(question.prompt);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(question.instance % 5));
        if (text == "fail" || text == "fatal") throw DisambiguationError(text, text == "fatal");
        if (text.empty()) return std::nullopt;
        DisambiguationAnswer answer;
        answer.text = text;
        answer.model = "script";
        answer.promptTokens = 100;
        answer.answerTokens = 10;
        answer.seconds = 2;
        return answer;
    }

    [[nodiscard]] std::string howToAnswer() const override { return byHand; }

    /** Number of instances asked about so far. */
    [[nodiscard]] size_t asked() const
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return prompts.size();
    }

 private:
    mutable std::mutex m_mutex;
};
IMPLEMENTS_MRPT_OBJECT(CScripted, voxeland::CDisambiguator, voxeland::test)
}  // namespace voxeland::test

namespace
{
std::shared_ptr<test::CScripted> scripted(
    const std::map<instance_id_t, std::vector<std::string>>& script)
{
    auto backend = std::make_shared<test::CScripted>();
    backend->script = script;
    return backend;
}

DisambiguationQuestion question(instance_id_t id)
{
    DisambiguationQuestion q;
    q.instance = id;
    q.candidates = {{0, "chair", 0.6}, {1, "couch", 0.4}};
    q.prompt = "What is it?";
    return q;
}

std::map<instance_id_t, QuestionOutcome> askAll(DisambiguationRun& asking)
{
    std::map<instance_id_t, QuestionOutcome> all;
    while (auto outcomes = asking.next())
        for (auto& o : *outcomes) all[o.instance] = std::move(o);
    return all;
}
}  // namespace

TEST(DisambiguationRun, EachAttemptHasWordsOfItsOwn)
{
    const auto backend = scripted({{7, {"hm"}}});
    askUntilUsable(*backend, question(7), {});
    const auto& prompts = backend->prompts[7];
    EXPECT_EQ(prompts.size(), 3U);
    EXPECT_EQ(std::set<std::string>(prompts.begin(), prompts.end()).size(), 3U)
        << "a recorded answer belongs to the words of its question";
}

TEST(DisambiguationRun, WhoeverAnswersByHandIsAskedOnceAndMayAnswerLater)
{
    const auto backend = scripted({{7, {"hm"}}, {8, {""}}, {9, {"couch"}}});
    EXPECT_FALSE(askUntilUsable(*backend, question(7), {}).waiting) << "asked in vain";
    EXPECT_TRUE(askUntilUsable(*backend, question(8), {}).waiting);
    backend->byHand = "write it down";
    backend->prompts.clear();
    const auto unclear = askUntilUsable(*backend, question(7), {});
    EXPECT_TRUE(unclear.waiting);
    EXPECT_NE(unclear.problem.find("hm"), std::string::npos) << unclear.problem;
    EXPECT_EQ(backend->prompts[7].size(), 1U);
    const auto clear = askUntilUsable(*backend, question(9), {});
    EXPECT_TRUE(clear.decision);
    EXPECT_FALSE(clear.waiting);
}

TEST(DisambiguationRun, ADecisionRemembersWhoSaidWhatAndWhatItTook)
{
    DisambiguationOptions options;
    options.prompt_price = 1000;
    options.answer_price = 20000;
    const auto backend = scripted({{7, {"hm", "The object category is couch."}}});
    const auto outcome = askUntilUsable(*backend, question(7), options);
    ASSERT_TRUE(outcome.decision);
    EXPECT_EQ(outcome.decision->category, 1U);
    EXPECT_EQ(outcome.decision->source, "voxeland::test::CScripted");
    EXPECT_EQ(outcome.decision->model, "script");
    EXPECT_EQ(outcome.decision->answer, "The object category is couch.");
    EXPECT_EQ(outcome.decision->questions, 2U);
    EXPECT_EQ(outcome.decision->promptTokens, 200U);
    EXPECT_EQ(outcome.decision->answerTokens, 20U);
    EXPECT_DOUBLE_EQ(outcome.decision->seconds, 4);
    EXPECT_DOUBLE_EQ(outcome.decision->cost, 200 * 1e-3 + 20 * 20e-3);
    EXPECT_EQ(backend->prompts[7][0], "What is it?");
    EXPECT_NE(backend->prompts[7][1].find("chair, couch, unknown"), std::string::npos);
}

TEST(DisambiguationRun, GivesUpAfterMaxAttemptsAndWaitsForNoOne)
{
    DisambiguationOptions options;
    options.max_attempts = 3;
    const auto backend = scripted({{1, {"chair or couch"}}, {2, {""}}});
    const auto useless = askUntilUsable(*backend, question(1), options);
    EXPECT_FALSE(useless.decision);
    EXPECT_NE(useless.problem.find("chair or couch"), std::string::npos);
    EXPECT_EQ(backend->prompts[1].size(), 3U);
    EXPECT_FALSE(askUntilUsable(*backend, question(2), options).decision);
    EXPECT_EQ(backend->prompts[2].size(), 1U);
}

TEST(DisambiguationRun, TheNextQuestionWaitsUntilTheAnswerIsKept)
{
    DisambiguationOptions options;
    options.parallel = 1;
    const auto backend = scripted({{1, {"chair"}}, {2, {"couch"}}});
    DisambiguationRun asking(backend, {question(1), question(2)}, options);
    auto outcomes = asking.next();
    while (outcomes->empty()) outcomes = asking.next();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(backend->asked(), 1U) << "the caller may still be writing";
    EXPECT_EQ(askAll(asking).size(), 1U);
    EXPECT_EQ(backend->asked(), 2U);
}

TEST(DisambiguationRun, OutcomesDoNotDependOnTheNumberOfThreads)
{
    std::map<instance_id_t, std::vector<std::string>> script;
    std::vector<DisambiguationQuestion> questions;
    for (instance_id_t id = 1; id <= 40; ++id) {
        script[id] = {id % 7 == 0 ? "fail" : id % 3 == 0 ? "chair" : id % 3 == 1 ? "couch" : "?"};
        questions.push_back(question(id));
    }
    for (const uint32_t threads : {1U, 2U, 16U}) {
        DisambiguationOptions options;
        options.parallel = threads;
        DisambiguationRun asking(scripted(script), questions, options);
        const auto outcomes = askAll(asking);
        ASSERT_EQ(outcomes.size(), 40U);
        for (const auto& [id, o] : outcomes) {
            EXPECT_EQ(o.failed, id % 7 == 0);
            ASSERT_EQ(o.decision.has_value(), id % 7 != 0 && id % 3 != 2) << id;
            if (o.decision) {
                EXPECT_EQ(o.decision->category, id % 3);
            }
        }
        EXPECT_NO_THROW(asking.rethrow());
    }
}

TEST(DisambiguationRun, AFatalFailureEndsItWithWhatWasAnswered)
{
    DisambiguationOptions options;
    options.parallel = 1;
    const auto backend = scripted({{1, {"chair"}}, {2, {"fatal"}}, {3, {"chair"}}});
    DisambiguationRun asking(backend, {question(1), question(2), question(3)}, options);
    const auto outcomes = askAll(asking);
    EXPECT_EQ(outcomes.size(), 2U);
    EXPECT_TRUE(outcomes.at(1).decision);
    EXPECT_TRUE(outcomes.at(2).failed);
    EXPECT_EQ(backend->prompts.count(3), 0U);
    EXPECT_THROW(asking.rethrow(), DisambiguationError);
}

TEST(DisambiguationRun, NothingToAskIsSoonDone)
{
    DisambiguationRun asking(scripted({}), {}, {});
    EXPECT_FALSE(asking.next());
}
