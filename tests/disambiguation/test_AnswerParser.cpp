// SPDX-License-Identifier: BSD-3-Clause
#include "voxeland/disambiguation/AnswerParser.h"

#include <gtest/gtest.h>

using namespace voxeland;

namespace
{
constexpr category_id_t TABLE = 4, DINING_TABLE = 2, TV = 9;

std::optional<category_id_t> named(const std::string& answer)
{
    return categoryNamedBy(
        answer, {{DINING_TABLE, "dining table", 0.5}, {TABLE, "table", 0.3}, {TV, "TV", 0.2}});
}
}  // namespace

TEST(AnswerParser, TheFormThatWasAskedFor)
{
    EXPECT_EQ(named("The object category is table"), TABLE);
    EXPECT_EQ(named("The object category is dining table."), DINING_TABLE);
    EXPECT_EQ(named("the OBJECT category is: tv\n"), TV);
    EXPECT_EQ(named("**The object category is \"Dining Table\".**"), DINING_TABLE);
    EXPECT_EQ(named("The object category is <table>"), TABLE);
    EXPECT_EQ(named("It has no legs and is not a tv.\n\nThe object category is table.\n"), TABLE);
    EXPECT_EQ(named("The object category is unknown"), UNKNOWN_CATEGORY_ID);
}

TEST(AnswerParser, TheFormMustNameOneCandidateAndNothingElse)
{
    for (const char* answer :
         {"The object category is giraffe", "The object category is table or tv",
          "The object category is not table", "The object category is",
          "The object category is tables", "The object category is a table maybe",
          "The object category is table. The object category is tv."})
        EXPECT_EQ(named(answer), std::nullopt) << answer;
    EXPECT_EQ(named("The object category is tv. Yes: the object category is TV!"), TV);
}

TEST(AnswerParser, WithoutTheFormOneWholeNameMustOccur)
{
    EXPECT_EQ(named("Table"), TABLE);
    EXPECT_EQ(named("I would say: a dining table."), DINING_TABLE)
        << "the name within another does not count";
    EXPECT_EQ(named("unknown"), UNKNOWN_CATEGORY_ID);
    for (const char* answer : {"", "a giraffe", "tablet", "table, tv", "It is not a table",
                               "It isn't a tv", "a dining table or a table", "unknown; a table?"})
        EXPECT_EQ(named(answer), std::nullopt) << answer;
}
