// SPDX-License-Identifier: BSD-3-Clause
/** The back-ends that need no network. */
#include "Backend.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

using namespace voxeland;
using test::couchOrChair;
namespace fs = std::filesystem;

namespace
{
std::shared_ptr<CDisambiguator> top()
{
    return test::backend("top_category", "CTopCategoryDisambiguator", "");
}

class ReplayDisambiguator : public testing::Test
{
 protected:
    std::shared_ptr<CDisambiguator> replay(const std::string& keys = "") const
    {
        return test::backend("replay", "CReplayDisambiguator",
                             "folder = " + questions() + "\n" + keys);
    }
    /** Replays, and records the answers of the baseline. */
    std::shared_ptr<CDisambiguator> recorder(const std::string& keys = "") const
    {
        const std::string ini = m_folder.file("record.ini");
        test::writeFile(ini, "[disambiguation]\nclass = CTopCategoryDisambiguator\n" + keys);
        return replay("record_config = " + ini + "\n");
    }
    [[nodiscard]] std::string questions() const { return m_folder.file("questions"); }
    /** The folder of the only question. */
    [[nodiscard]] fs::path onlyQuestion() const
    {
        std::vector<fs::path> folders;
        for (const auto& entry : fs::directory_iterator(questions()))
            folders.push_back(entry.path());
        EXPECT_EQ(folders.size(), 1U);
        return folders.at(0);
    }

    test::TemporaryFolder m_folder;
};
}  // namespace

TEST(TopCategoryDisambiguator, answersWithTheLikeliestCandidate)
{
    EXPECT_EQ(top()->ask(couchOrChair())->text, "The object category is couch.");
    EXPECT_EQ(top()->ask({})->text, "The object category is unknown.");
}

TEST_F(ReplayDisambiguator, aQuestionWithoutAnAnswerIsWrittenOut)
{
    EXPECT_FALSE(replay()->ask(couchOrChair()));
    const fs::path folder = onlyQuestion();
    EXPECT_EQ(folder.filename().string().rfind("instance-7-", 0), 0U) << folder;
    EXPECT_EQ(test::readFile(folder / "prompt.txt"), couchOrChair().prompt);
    EXPECT_EQ(test::readFile(folder / "picture-01.png"), couchOrChair().pictures[0].bytes);
    EXPECT_EQ(test::readFile(folder / "picture-02.jpg"), couchOrChair().pictures[1].bytes);
    const auto json = nlohmann::json::parse(test::readFile(folder / "question.json"));
    EXPECT_EQ(json["instance"], 7);
    EXPECT_EQ(json["candidates"][1]["category"], "chair");
    EXPECT_EQ(json["candidates"][1]["probability"], 0.4);
    EXPECT_EQ(json["pictures"][1]["file"], "picture-02.jpg");
    EXPECT_EQ(json["pictures"][1]["caption"], "from the right");
    const std::string form = test::readFile(folder / "answer.txt");
    EXPECT_NE(form.find("couch, chair, unknown"), std::string::npos) << form;
    std::istringstream lines(form);
    for (std::string line; std::getline(lines, line);) EXPECT_EQ(line.front(), '#') << line;
}

TEST_F(ReplayDisambiguator, aPersonAnswersByEditingOneFile)
{
    EXPECT_FALSE(replay()->ask(couchOrChair()));
    std::ofstream(onlyQuestion() / "answer.txt", std::ios::app)
        << "\n  The object category is chair. \r\n# not sure\n";
    EXPECT_FALSE(replay()->ask(couchOrChair({1, 2, 3}))) << "other pictures, another question";
    const auto answer = replay()->ask(couchOrChair());
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->text, "The object category is chair.");
    EXPECT_EQ(answer->model, "a person");
}

TEST_F(ReplayDisambiguator, saysWhereAPersonAnswersUnlessAnotherBackEndDoes)
{
    EXPECT_NE(replay()->howToAnswer().find("'" + questions() + "'"), std::string::npos)
        << replay()->howToAnswer();
    EXPECT_EQ(recorder()->howToAnswer(), "");
    EXPECT_TRUE(replay()->keepsAnswers());
    EXPECT_FALSE(top()->keepsAnswers());
}

TEST_F(ReplayDisambiguator, anEditorMayHaveAddedAByteOrderMark)
{
    EXPECT_FALSE(replay()->ask(couchOrChair()));
    const fs::path file = onlyQuestion() / "answer.txt";
    test::writeFile(file, "\xef\xbb\xbf" + test::readFile(file));
    EXPECT_FALSE(replay()->ask(couchOrChair())) << "the first line does not count";
    std::ofstream(file, std::ios::app) << "chair\r\n";
    EXPECT_EQ(replay()->ask(couchOrChair())->text, "chair");
}

TEST_F(ReplayDisambiguator, askingAgainKeepsWhatAPersonWrote)
{
    EXPECT_FALSE(replay()->ask(couchOrChair()));
    const fs::path file = onlyQuestion() / "answer.txt";
    test::writeFile(file, "# thinking about it\n\n");
    EXPECT_FALSE(replay()->ask(couchOrChair()));
    EXPECT_EQ(test::readFile(file), "# thinking about it\n\n");
}

TEST_F(ReplayDisambiguator, instancePromptAndPicturesMakeAQuestion)
{
    std::vector<DisambiguationQuestion> different(5, couchOrChair());
    different[1].instance = 8;
    different[2].prompt += " ";
    different[3].pictures[1].bytes = test::picture({20, 20, 21}, 40, 30);
    different[4].pictures.pop_back();
    const auto asked = replay();
    for (const auto& question : different) EXPECT_FALSE(asked->ask(question));
    std::set<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(questions())) folders.insert(entry.path());
    EXPECT_EQ(folders.size(), different.size());
}

TEST_F(ReplayDisambiguator, recordsAnotherBackEndAndRepeatsItWithoutIt)
{
    const auto first = recorder()->ask(couchOrChair());
    ASSERT_TRUE(first);
    EXPECT_EQ(first->text, "The object category is couch.");
    EXPECT_FALSE(fs::exists(onlyQuestion() / "answer.txt")) << "nobody is asked";
    const auto again = replay()->ask(couchOrChair());
    ASSERT_TRUE(again);
    EXPECT_EQ(again->text, first->text);
    EXPECT_EQ(again->model, first->model);
    EXPECT_EQ(again->seconds, first->seconds);
}

TEST_F(ReplayDisambiguator, aRecordedAnswerIsNotAskedForAgain)
{
    ASSERT_TRUE(recorder()->ask(couchOrChair()));
    const fs::path file = onlyQuestion() / "answer.json";
    test::writeFile(file, R"({"text": "chair", "model": "m", "prompt_tokens": 3,
                             "answer_tokens": 2, "seconds": 0.5})");
    const auto answer = recorder()->ask(couchOrChair());
    EXPECT_EQ(answer->text, "chair");
    EXPECT_EQ(answer->promptTokens, 3U);
    EXPECT_EQ(answer->answerTokens, 2U);
    EXPECT_EQ(answer->seconds, 0.5);
    test::writeFile(onlyQuestion() / "answer.txt", "The object category is couch.");
    EXPECT_EQ(recorder()->ask(couchOrChair())->model, "a person") << "who may overrule it";
}

TEST_F(ReplayDisambiguator, aDamagedRecordNamesTheFile)
{
    ASSERT_TRUE(recorder()->ask(couchOrChair()));
    const fs::path file = onlyQuestion() / "answer.json";
    for (const char* content : {"{\"text\": ", "[]", "{\"text\": 1}"}) {
        test::writeFile(file, content);
        try {
            (void)replay()->ask(couchOrChair());
            ADD_FAILURE() << content;
        } catch (const DisambiguationError& e) {
            EXPECT_FALSE(e.fatal);
            EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos) << e.what();
        }
    }
}

TEST_F(ReplayDisambiguator, wrongKeysAreNamed)
{
    EXPECT_THROW(recorder("folderr = x\n"), ConfigurationError);
    EXPECT_THROW(replay("record_config = " + m_folder.file("none.ini") + "\n"), ConfigurationError);
    EXPECT_THROW(test::backend("replay", "CReplayDisambiguator", "folder =\n"), ConfigurationError);
    test::writeFile(questions() + "2", "a file");
    EXPECT_THROW(test::backend("replay", "CReplayDisambiguator", "folder = " + questions() + "2\n"),
                 OutputError);
}
