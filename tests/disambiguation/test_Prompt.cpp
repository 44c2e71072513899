// SPDX-License-Identifier: BSD-3-Clause
#include "disambiguation/Prompt.h"
#include "support/TestFiles.h"
#include "voxeland/base/errors.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
DisambiguationQuestion question()
{
    DisambiguationQuestion q;
    q.candidates = {{0, "couch", 0.625}, {1, "bed {names}", 0.25}};
    q.pictures = {{"from the left", "", ""}, {"from above", "", ""}};
    return q;
}
}  // namespace

TEST(Prompt, PlaceholdersAreFilledOnce)
{
    const test::TemporaryFolder folder;
    const std::string file = folder.file("prompt.txt");
    test::writeFile(file, "Is it\n{candidates}\nor {names}? {pictures} {other}\n");
    EXPECT_EQ(Prompt(file).words(question()),
              "Is it\n- couch: 0.62\n- bed {names}: 0.25\nor couch, bed {names}? "
              "1. from the left\n2. from above {other}\n");
}

TEST(Prompt, TheBuiltInOneSaysEverything)
{
    const std::string words = Prompt().words(question());
    for (const char* part : {"couch: 0.62", "1. from the left", "2. from above",
                             "The object category is <category>", "unknown"})
        EXPECT_NE(words.find(part), std::string::npos) << part;
}

TEST(Prompt, UnusableTemplatesAreRefused)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(Prompt(folder.file("none.txt")), ConfigurationError);
    test::writeFile(folder.file("mute.txt"), "What is it?");
    EXPECT_THROW(Prompt(folder.file("mute.txt")), ConfigurationError);
}
