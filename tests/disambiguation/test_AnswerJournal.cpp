// SPDX-License-Identifier: BSD-3-Clause
#include "disambiguation/AnswerJournal.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
class AnswerJournalTest : public testing::Test
{
 protected:
    void SetUp() override
    {
        test::writeFile(m_input, "a map");
        for (int i = 0; i < 3; ++i) m_map.createInstance();
        m_map.categories().add("chair");
    }

    [[nodiscard]] AnswerJournal open(const std::string& source = "Backend") const
    {
        return {m_folder.file("out.voxeland"), m_input, source};
    }
    std::vector<std::string> replayed(const std::string& source = "Backend")
    {
        std::vector<std::string> answers;
        open(source).replay(m_map, [&](instance_id_t id, const Decision& d) {
            answers.push_back(std::to_string(id) + " " + d.answer);
        });
        return answers;
    }
    static Decision decision(const std::string& answer)
    {
        Decision d;
        d.category = 0;
        d.evidence = 1;
        d.answer = answer;
        return d;
    }
    using Answers = std::vector<std::string>;

    test::TemporaryFolder m_folder;
    const std::string m_input = m_folder.file("in.voxeland");
    SemanticVoxelMap m_map;
};
}  // namespace

TEST_F(AnswerJournalTest, GivesWhatWasAnsweredBeforeARunWasKilled)
{
    {
        AnswerJournal journal = open();
        journal.add(2, decision("a chair"));
        journal.add(1, decision("no chair"));
    }
    EXPECT_EQ(replayed(), (Answers{"2 a chair", "1 no chair"}));
    EXPECT_EQ(replayed(), (Answers{"2 a chair", "1 no chair"})) << "killed once more";
    AnswerJournal journal = open();
    journal.add(3, decision("a stool"));
    EXPECT_THROW(open(), OutputError) << "another run is at it";
}

TEST_F(AnswerJournalTest, AnswersAboutAnotherMapOrOfAnotherBackendAreNotMixedIn)
{
    open().add(2, decision("a chair"));
    EXPECT_EQ(replayed("Another"), Answers());
    open().add(2, decision("a chair"));
    test::writeFile(m_input, "a mop");
    EXPECT_EQ(replayed(), Answers());
}

TEST_F(AnswerJournalTest, IsRemovedOnceTheMapIsWritten)
{
    AnswerJournal journal = open();
    journal.add(2, decision("a chair"));
    journal.discard();
    EXPECT_FALSE(std::filesystem::exists(m_folder.file("out.voxeland.answers")));
}
